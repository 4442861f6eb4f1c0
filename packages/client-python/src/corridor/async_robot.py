"""The same robot for asyncio: the same words, each of them awaited."""

from __future__ import annotations

from types import TracebackType
from typing import AsyncIterator, Callable, List, Optional, Type

from .actions import (
    Action,
    check_ttl,
    go_forward,
    go_reverse,
    plain,
    power_wheels,
    turn_by,
    turn_left,
    turn_right,
)
from .address import parse_address
from .async_transport import run_async
from .errors import RobotError
from .transport import Line
from .pairing import pair
from .reports import Command, Event, Maze, Sensors, Snapshot
from .requests import T, Talk
from .protocol import RobotTalk


class AsyncRobot:
    """A robot for scripts that do several things at once, with asyncio.

    Use it as `async with AsyncRobot(ADDRESS) as robot:` or `robot = await AsyncRobot.connect(ADDRESS)`.
    Parameters, results and errors are those of `Robot` and of its methods with the same names. `sensor`,
    `goal_reached` and `bumps` are missing: read them from `await robot.snapshot()`.
    """

    def __init__(
        self,
        address: str,
        key: Optional[str] = None,
        *,
        answer_timeout: float = 30.0,
        finish_timeout: float = 600.0,
        ttl: Optional[float] = None,
        name: Optional[str] = None,
    ) -> None:
        where = parse_address(address, key)
        self._talk = RobotTalk(where, answer_timeout, finish_timeout, check_ttl(ttl), name=name)
        self._line = Line()

    @classmethod
    async def connect(
        cls,
        address: str,
        key: Optional[str] = None,
        *,
        answer_timeout: float = 30.0,
        finish_timeout: float = 600.0,
        ttl: Optional[float] = None,
        name: Optional[str] = None,
    ) -> AsyncRobot:
        """Makes an `AsyncRobot`, and checks that the robot is there and takes the key."""
        robot = cls(
            address,
            key,
            answer_timeout=answer_timeout,
            finish_timeout=finish_timeout,
            ttl=ttl,
            name=name,
        )
        await robot._run(robot._talk.greet())
        return robot

    @classmethod
    async def pair(
        cls,
        service: str,
        code: str,
        *,
        answer_timeout: float = 30.0,
        finish_timeout: float = 600.0,
        ttl: Optional[float] = None,
        name: Optional[str] = None,
    ) -> AsyncRobot:
        """Connects by a code of 8 letters, and waits until the robot's owner accepts this script."""
        address = await run_async(pair(service, code, name, answer_timeout), Line())
        return await cls.connect(
            address,
            answer_timeout=answer_timeout,
            finish_timeout=finish_timeout,
            ttl=ttl,
            name=name,
        )

    @property
    def address(self) -> str:
        """The whole address, with its key. Keep it private."""
        return self._talk.address.whole

    # --- measured: they end by themselves, or at a wall ---

    async def forward(self, distance: Optional[float] = None) -> Command:
        """Drives forward, and waits for the end; without a distance, until another command comes."""
        return await self._do(go_forward(distance))

    async def reverse(self, distance: Optional[float] = None) -> Command:
        """Drives backward, as `forward` drives forward."""
        return await self._do(go_reverse(distance))

    async def left(self, degrees: float = 90) -> Command:
        """Turns left on the spot, and waits for the end."""
        return await self._do(turn_left(degrees))

    async def right(self, degrees: float = 90) -> Command:
        """Turns right on the spot, and waits for the end."""
        return await self._do(turn_right(degrees))

    async def turn(self, degrees: float) -> Command:
        """Turns on the spot, and waits for the end. Negative is left."""
        return await self._do(turn_by(degrees))

    async def delayed_left(self) -> Command:
        """Drives on 50 cm, turns left, drives 60 cm out of the junction, and waits for the end."""
        return await self._do(plain("delayed left 90"))

    async def delayed_right(self) -> Command:
        """Drives on 50 cm, turns right, drives 60 cm out of the junction, and waits for the end."""
        return await self._do(plain("delayed right 90"))

    async def drive(self, left: float, right: float, milliseconds: Optional[float] = None) -> Command:
        """Sets the power of the two wheels, for a time, and waits for the end."""
        return await self._do(power_wheels(left, right, milliseconds))

    async def stop(self) -> Command:
        """Stops at once: cancels the running command and all waiting ones, from every script."""
        return await self._run(self._talk.stop())

    # --- reading and waiting ---

    async def sensors(self) -> Sensors:
        """Reads the four distances: `(await robot.sensors()).front`."""
        return (await self.snapshot()).sensors

    async def snapshot(self) -> Snapshot:
        """Reads everything that the robot reports."""
        return await self._run(self._talk.look())

    async def snapshots(self) -> AsyncIterator[Snapshot]:
        """Follows the robot without an end: `async for snapshot in robot.snapshots():`."""
        while True:
            yield await self._run(self._talk.look(1.0))

    async def events(self) -> AsyncIterator[Event]:
        """Follows the robot and the commands of all scripts, without an end."""
        since: Optional[str] = None
        newest: Optional[Snapshot] = None
        while True:
            after = 0 if newest is None else newest.seq
            since, events = await self._run(self._talk.events(since, after))
            for event in events:
                # Each answer has the newest report, also where only a command has changed.
                if event.snapshot is not None and event.snapshot == newest:
                    continue
                newest = event.snapshot or newest
                yield event

    async def maze(self) -> Maze:
        """Reads the maze that the robot is in."""
        return await self._run(self._talk.maze())

    async def wait_until(
        self, condition: Callable[[Sensors], object], timeout: Optional[float] = None
    ) -> Sensors:
        """Waits until a condition holds: `await robot.wait_until(lambda sensor: sensor.front < 60)`."""
        return await self._run(self._talk.wait_until(condition, timeout))

    async def wait(self, seconds: float) -> None:
        """Waits, and lets the robot go on with what it does, unlike `asyncio.sleep`."""
        await self._run(self._talk.wait(seconds))

    async def commands(self) -> List[Command]:
        """Reads the log: the record of every command that the robot's host stores, oldest first."""
        return await self._run(self._talk.log())

    # --- the end ---

    def close(self) -> None:
        """Ends the use of this object. The robot goes on with what it does."""
        self._talk.is_closed = True

    async def __aenter__(self) -> AsyncRobot:
        await self._run(self._talk.greet())
        return self

    async def __aexit__(
        self,
        kind: Optional[Type[BaseException]],
        _error: Optional[BaseException],
        _trace: Optional[TracebackType],
    ) -> None:
        """Stops the robot if it would drive on by itself, and leaves it."""
        try:
            if self._talk.drives_on and not self._talk.is_closed:
                await self.stop()
        except RobotError:
            # What went wrong first is what the reader has to know.
            if kind is None:
                raise
        finally:
            self.close()

    def __repr__(self) -> str:
        address = self._talk.address
        return f"<AsyncRobot {address.origin}/r/{address.id}>"

    async def _do(self, action: Action) -> Command:
        return await self._run(self._talk.do(action))

    async def _run(self, talk: Talk[T]) -> T:
        return await run_async(talk, self._line)
