"""Runs exchanges without blocking the event loop: each request has its own thread.

The threads are daemons, so that a script can exit during a long poll.
"""

from __future__ import annotations

import asyncio
import threading

from .transport import HttpTransport
from .requests import Response, Delay, Request, T, Exchange


async def run_async(exchange: Exchange[T], transport: HttpTransport) -> T:
    """Runs an exchange to its end, without blocking the event loop."""
    try:
        step = next(exchange)
        while True:
            if isinstance(step, Delay):
                await asyncio.sleep(step.seconds)
                step = exchange.send(None)
            else:
                step = exchange.send(await _send(step, transport))
    except StopIteration as end:
        result: T = end.value
        return result


async def _send(request: Request, transport: HttpTransport) -> Response:
    loop = asyncio.get_running_loop()
    future: asyncio.Future[Response] = loop.create_future()

    def complete(response: Response) -> None:
        if not future.done():
            future.set_result(response)

    def work() -> None:
        response = transport.send(request)
        try:
            loop.call_soon_threadsafe(complete, response)
        except RuntimeError:
            # The loop is closed: nothing waits for the response.
            return

    threading.Thread(target=work, name="corridor request", daemon=True).start()
    return await future
