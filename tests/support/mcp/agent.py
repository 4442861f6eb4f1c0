"""An agent in Python: follows the right wall by MCP, with sense and act alone.

    python agent.py auto|legacy URL KEY
    CORRIDOR_ROBOT=ADDRESS python agent.py auto|legacy COMMAND...

Prints one line of JSON: the tools, the last snapshot, a refusal, and by HTTP the answer to a call
that was repeated because its first answer was lost.
"""

import asyncio
import json
import os
import sys

from mcp import Client, StdioServerParameters
from mcp.client.stdio import stdio_client
from mcp.client.streamable_http import create_mcp_http_client, streamable_http_client

LOST_S = 5


def seen(result):
    if result.is_error:
        raise SystemExit(result.content[0].text)
    return result.structured_content["snapshot"]


async def solve(agent):
    snapshot = seen(await agent.call_tool("sense", {}))
    step = 0
    while not snapshot["goalReached"] and step < 100:
        sensors = snapshot["sensors"]
        if sensors["right"] > 100:
            actions = [{"action": "right 90"}, {"action": "move", "distance": 100}]
        elif sensors["front"] > 100:
            actions = [{"action": "move", "distance": 100}]
        else:
            actions = [{"action": "left 90"}]
        for action in actions:
            step += 1
            snapshot = seen(await agent.call_tool("act", {**action, "key": f"step-{step:04}"}))
    return snapshot


class LostAnswerError(Exception):
    """The connection ends after the server has answered."""


async def lose(response):
    raise LostAnswerError(response.url)


async def repeat(mode, url, key):
    """Calls `act`, loses the answer, and repeats the call with its key."""
    turn = {"action": "turn", "degrees": 90, "key": "again-0001"}
    http = create_mcp_http_client(headers={"Authorization": f"Bearer {key}"})
    try:
        async with Client(streamable_http_client(url, http_client=http), mode=mode) as agent:
            await agent.list_tools()
            http.event_hooks = {"request": [], "response": [lose]}
            await asyncio.wait_for(agent.call_tool("act", turn), timeout=LOST_S)
    except BaseException as lost:  # the library reports it as a group of exceptions, or not at all
        print(repr(lost), file=sys.stderr)
    else:
        raise SystemExit("the answer was not lost")
    async with Client(transport(url, key), mode=mode) as agent:
        return (await agent.call_tool("act", turn)).content[0].text


def transport(program, *args):
    if not program.startswith("http"):
        environment = {"CORRIDOR_ROBOT": os.environ["CORRIDOR_ROBOT"]}
        return stdio_client(
            StdioServerParameters(command=program, args=list(args), env=environment)
        )
    [key] = args
    http = create_mcp_http_client(headers={"Authorization": f"Bearer {key}"})
    return streamable_http_client(program, http_client=http)


async def main(mode, *server):
    is_remote = server[0].startswith("http")
    async with Client(transport(*server), mode=mode) as agent:
        tools = [tool.name for tool in (await agent.list_tools()).tools]
        snapshot = await solve(agent)
        refused = await agent.call_tool("act", {"action": "move", "distance": 90000})
        print(
            json.dumps(
                {
                    "tools": tools,
                    "snapshot": snapshot,
                    "refused": refused.is_error,
                    "sentence": refused.content[0].text,
                    "repeated": await repeat(mode, *server) if is_remote else None,
                }
            )
        )


asyncio.run(main(*sys.argv[1:]))
