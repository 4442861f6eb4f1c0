"""Has a talk without holding up the event loop: each request waits in a thread of its own.

The threads are daemons, so that a script which is ended does not wait for a long poll to come back.
"""

from __future__ import annotations

import asyncio
import threading

from .transport import Line
from .requests import Answer, Pause, Request, T, Talk


async def run_async(talk: Talk[T], line: Line) -> T:
    """Has a talk from its beginning to its end, and lets others work meanwhile."""
    try:
        step = next(talk)
        while True:
            if isinstance(step, Pause):
                await asyncio.sleep(step.seconds)
                step = talk.send(None)
            else:
                step = talk.send(await _send(step, line))
    except StopIteration as end:
        result: T = end.value
        return result


async def _send(request: Request, line: Line) -> Answer:
    loop = asyncio.get_running_loop()
    answered: asyncio.Future[Answer] = loop.create_future()

    def take(answer: Answer) -> None:
        if not answered.done():
            answered.set_result(answer)

    def work() -> None:
        answer = line.send(request)
        try:
            loop.call_soon_threadsafe(take, answer)
        except RuntimeError:
            # The loop was closed meanwhile: nobody waits any more.
            return

    threading.Thread(target=work, name="corridor request", daemon=True).start()
    return await answered
