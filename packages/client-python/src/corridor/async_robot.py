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
from .async_line import run_async
from .errors import RobotError
from .line import Line
from .pairing import pair
from .reports import Command, Event, Maze, Sensors, Snapshot
from .requests import T, Talk
from .talk import RobotTalk


class AsyncRobot:
    """A robot for scripts that do several things at once.

    `async with AsyncRobot(ADDRESS) as robot:` or `robot = await AsyncRobot.connect(ADDRESS)`. The
    arguments are those of Robot.
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
        """A robot that is known to be there, with a key that fits."""
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
        """The robot whose page at `service`, such as `http://HOST`, shows this code.

        Waits until whoever has the page says yes. `address` of the robot can be kept for the next time.
        """
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
        """The whole address, with its key: keep it private."""
        return self._talk.address.whole

    # --- measured: they end by themselves, or at a wall ---

    async def forward(self, distance: Optional[float] = None) -> Command:
        """Drives so many cm; without a number: until something else is chosen."""
        return await self._do(go_forward(distance))

    async def reverse(self, distance: Optional[float] = None) -> Command:
        """Drives backward so many cm; without a number: until something else is chosen."""
        return await self._do(go_reverse(distance))

    async def left(self, degrees: float = 90) -> Command:
        """Turns left on the spot."""
        return await self._do(turn_left(degrees))

    async def right(self, degrees: float = 90) -> Command:
        """Turns right on the spot."""
        return await self._do(turn_right(degrees))

    async def turn(self, degrees: float) -> Command:
        """Turns on the spot; negative is left."""
        return await self._do(turn_by(degrees))

    async def delayed_left(self) -> Command:
        """Drives on 50 cm, turns left, drives 60 cm out of the junction."""
        return await self._do(plain("delayed left 90"))

    async def delayed_right(self) -> Command:
        """Drives on 50 cm, turns right, drives 60 cm out of the junction."""
        return await self._do(plain("delayed right 90"))

    async def drive(self, left: float, right: float, milliseconds: Optional[float] = None) -> Command:
        """Wheel powers from -1 to 1 for a time; without a time: until something else is chosen."""
        return await self._do(power_wheels(left, right, milliseconds))

    async def stop(self) -> Command:
        """Stops at once: ends what runs, and drops what waits, whoever sent it."""
        return await self._run(self._talk.stop())

    # --- reading and waiting ---

    async def sensors(self) -> Sensors:
        """The four distances as they are now: `(await robot.sensors()).front`."""
        return (await self.snapshot()).sensors

    async def snapshot(self) -> Snapshot:
        """All that the robot reports now, never from before the end of the last command."""
        return await self._run(self._talk.look())

    async def snapshots(self) -> AsyncIterator[Snapshot]:
        """One report after the other as they come; a slow reader gets the newest each time."""
        while True:
            yield await self._run(self._talk.look(1.0))

    async def events(self) -> AsyncIterator[Event]:
        """What happens from now on, as it happens: newer reports, and commands whose state changes.

        It begins with a report. A reader that was slow gets the newest report, and every command.
        """
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
        """The maze that the robot is in: its blocks, its start and its goals."""
        return await self._run(self._talk.maze())

    async def wait_until(
        self, condition: Callable[[Sensors], object], timeout: Optional[float] = None
    ) -> Sensors:
        """Waits until a condition holds: `robot.wait_until(lambda sensor: sensor.front < 60)`."""
        return await self._run(self._talk.wait_until(condition, timeout))

    async def wait(self, seconds: float) -> None:
        """Lets the robot go on for so long. Unlike in asyncio.sleep(), it knows that you are there."""
        await self._run(self._talk.wait(seconds))

    async def commands(self) -> List[Command]:
        """The log: every command that the robot's host keeps, oldest first."""
        return await self._run(self._talk.log())

    # --- the end ---

    def close(self) -> None:
        """Leaves the robot as it is; this object can do nothing more."""
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
