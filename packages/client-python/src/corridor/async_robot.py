"""The robot for asyncio: the methods of `Robot` as coroutines."""

from __future__ import annotations

from types import TracebackType
from typing import TYPE_CHECKING, AsyncIterator, Callable, List, Optional, Type

from .actions import (
    Action,
    Until,
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
from .other_names import no_attribute
from .transport import HttpTransport
from .pairing import pair
from .reports import Command, Event, Maze, Sensors, Snapshot
from .requests import T, Exchange
from .protocol import RobotProtocol


class AsyncRobot:
    """A robot for scripts with asyncio.

    Use it as `async with AsyncRobot(ADDRESS) as robot:` or `robot = await AsyncRobot.connect(ADDRESS)`.
    Parameters, results and errors are those of `Robot` and of its methods with the same names. Use
    `await robot.snapshot()` instead of `sensor`, `goal_reached` and `bumps`.
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
        self._protocol = RobotProtocol(where, answer_timeout, finish_timeout, check_ttl(ttl), name=name)
        self._transport = HttpTransport()

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
        """Creates an `AsyncRobot`, and checks that the robot exists and accepts the key."""
        robot = cls(
            address,
            key,
            answer_timeout=answer_timeout,
            finish_timeout=finish_timeout,
            ttl=ttl,
            name=name,
        )
        await robot._run(robot._protocol.check_access())
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
        """Connects by a pairing code, and waits until the robot's owner accepts this script."""
        address = await run_async(pair(service, code, name, answer_timeout), HttpTransport())
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
        return self._protocol.address.whole

    # --- driving ---

    async def forward(
        self, distance: Optional[float] = None, *, until: Optional[Until] = None
    ) -> Command:
        """Drives forward, and waits for the end; without an end, until the next command."""
        return await self._do(go_forward(distance, until))

    async def reverse(
        self, distance: Optional[float] = None, *, until: Optional[Until] = None
    ) -> Command:
        """Drives backward, as `forward` drives forward."""
        return await self._do(go_reverse(distance, until))

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
        """Drives 50 cm forward, turns left, drives 60 cm out of the junction, and waits for the end."""
        return await self._do(plain("delayed left 90"))

    async def delayed_right(self) -> Command:
        """Drives 50 cm forward, turns right, drives 60 cm out of the junction, and waits for the end."""
        return await self._do(plain("delayed right 90"))

    async def drive(
        self,
        left: float,
        right: float,
        milliseconds: Optional[float] = None,
        *,
        until: Optional[Until] = None,
    ) -> Command:
        """Sets the power of the two wheels, for a time or until a condition, and waits for the end."""
        return await self._do(power_wheels(left, right, milliseconds, until))

    async def stop(self) -> Command:
        """Stops at once: cancels the running command and all waiting ones, from every script."""
        return await self._run(self._protocol.stop())

    async def reset(self) -> Command:
        """Puts the robot at its start, which begins a new run, and ends all earlier commands."""
        return await self._do(plain("reset"))

    # --- reading and waiting ---

    async def sensors(self) -> Sensors:
        """Reads the four range sensors: `(await robot.sensors()).front`."""
        return (await self.snapshot()).sensors

    async def snapshot(self) -> Snapshot:
        """Reads everything that the robot reports."""
        return await self._run(self._protocol.next_snapshot())

    async def snapshots(self) -> AsyncIterator[Snapshot]:
        """Follows the robot until the loop ends: `async for snapshot in robot.snapshots():`."""
        while True:
            yield await self._run(self._protocol.next_snapshot(1.0))

    async def events(self) -> AsyncIterator[Event]:
        """Follows the robot and the commands of all scripts, until the loop ends."""
        since: Optional[str] = None
        newest: Optional[Snapshot] = None
        while True:
            after = 0 if newest is None else newest.seq
            since, events = await self._run(self._protocol.events(since, after))
            for event in events:
                # Each response repeats the newest snapshot, even if only a command has changed.
                if event.snapshot is not None and event.snapshot == newest:
                    continue
                newest = event.snapshot or newest
                yield event

    async def maze(self) -> Maze:
        """Reads the robot's maze."""
        return await self._run(self._protocol.maze())

    async def wait_until(
        self, condition: Callable[[Sensors], object], timeout: Optional[float] = None
    ) -> Sensors:
        """Waits until a condition is true: `await robot.wait_until(lambda sensor: sensor.front < 60)`."""
        return await self._run(self._protocol.wait_until(condition, timeout))

    async def wait(self, seconds: float) -> None:
        """Waits while the robot continues its motion, unlike `asyncio.sleep`."""
        await self._run(self._protocol.wait(seconds))

    async def commands(self) -> List[Command]:
        """Reads the log: the record of every command that the robot's host stores, oldest first."""
        return await self._run(self._protocol.log())

    # --- the end ---

    def close(self) -> None:
        """Closes this object. The robot continues its motion."""
        self._protocol.is_closed = True

    async def __aenter__(self) -> AsyncRobot:
        await self._run(self._protocol.check_access())
        return self

    async def __aexit__(
        self,
        kind: Optional[Type[BaseException]],
        _error: Optional[BaseException],
        _trace: Optional[TracebackType],
    ) -> None:
        """Stops an endless motion, and closes this object."""
        try:
            if self._protocol.has_endless_motion and not self._protocol.is_closed:
                await self.stop()
        except RobotError:
            # Do not hide the first error.
            if kind is None:
                raise
        finally:
            self.close()

    def __repr__(self) -> str:
        address = self._protocol.address
        return f"<AsyncRobot {address.origin}/r/{address.id}>"

    if not TYPE_CHECKING:
        # Type checkers would accept every name.
        def __getattr__(self, name):
            raise no_attribute(self, name)

    async def _do(self, action: Action) -> Command:
        return await self._run(self._protocol.execute(action))

    async def _run(self, exchange: Exchange[T]) -> T:
        return await run_async(exchange, self._transport)
