"""A robot in the hands of a script. Every method waits until the robot has done it."""

from __future__ import annotations

from types import TracebackType
from typing import Callable, Iterator, List, Optional, Type

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
from .errors import RobotError
from .line import Line, run
from .live_sensor import LiveSensor
from .pairing import pair
from .reports import Command, Event, Maze, Sensors, Snapshot
from .requests import T, Talk
from .talk import RobotTalk


class Robot:
    """A robot somewhere on the network, in a page or of metal.

    `address` is `http://HOST/r/ID#KEY`, as the page shows it under Remote. `answer_timeout` is how
    many seconds a host may stay silent, reconnecting included; `finish_timeout` how many the robot
    may take for one command; `ttl` within how many a command must have begun, or it expires (0.2 to
    60; the host's own default is 10, also for stop(); the way to the host and back counts); `name` what this script calls itself, for the robot's owner.
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
        self._sensor = LiveSensor(self._read)
        self._run(self._talk.greet())

    @classmethod
    def pair(
        cls,
        service: str,
        code: str,
        *,
        answer_timeout: float = 30.0,
        finish_timeout: float = 600.0,
        ttl: Optional[float] = None,
        name: Optional[str] = None,
    ) -> Robot:
        """The robot whose page at `service`, such as `http://HOST`, shows this code.

        Waits until whoever has the page says yes. `address` of the robot can be kept for the next time.
        """
        address = run(pair(service, code, name, answer_timeout), Line())
        return cls(
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

    def forward(self, distance: Optional[float] = None) -> Command:
        """Drives so many cm; without a number: until something else is chosen."""
        return self._do(go_forward(distance))

    def reverse(self, distance: Optional[float] = None) -> Command:
        """Drives backward so many cm; without a number: until something else is chosen."""
        return self._do(go_reverse(distance))

    def left(self, degrees: float = 90) -> Command:
        """Turns left on the spot."""
        return self._do(turn_left(degrees))

    def right(self, degrees: float = 90) -> Command:
        """Turns right on the spot."""
        return self._do(turn_right(degrees))

    def turn(self, degrees: float) -> Command:
        """Turns on the spot; negative is left."""
        return self._do(turn_by(degrees))

    def delayed_left(self) -> Command:
        """Drives on 50 cm, turns left, drives 60 cm out of the junction."""
        return self._do(plain("delayed left 90"))

    def delayed_right(self) -> Command:
        """Drives on 50 cm, turns right, drives 60 cm out of the junction."""
        return self._do(plain("delayed right 90"))

    def drive(self, left: float, right: float, milliseconds: Optional[float] = None) -> Command:
        """Wheel powers from -1 to 1 for a time; without a time: until something else is chosen."""
        return self._do(power_wheels(left, right, milliseconds))

    def stop(self) -> Command:
        """Stops at once: ends what runs, and drops what waits, whoever sent it."""
        return self._run(self._talk.stop())

    # --- reading and waiting ---

    @property
    def sensor(self) -> LiveSensor:
        """The four distances: `robot.sensor.front`. Those of one decision are of one snapshot."""
        return self._sensor

    @property
    def goal_reached(self) -> bool:
        """Whether the robot has reached a goal since its start, read like a side of `sensor`."""
        return self._read("goal_reached").goal_reached

    @property
    def bumps(self) -> int:
        """How many walls the robot has met since its start, read like a side of `sensor`."""
        return self._read("bumps").bumps

    def sensors(self) -> Sensors:
        """The four distances as they are now, in one object that stays as it is."""
        return self.snapshot().sensors

    def snapshot(self) -> Snapshot:
        """All that the robot reports now, never from before the end of the last command."""
        return self._run(self._talk.look())

    def snapshots(self) -> Iterator[Snapshot]:
        """One report after the other as they come; a slow reader gets the newest each time."""
        while True:
            yield self._run(self._talk.look(1.0))

    def events(self) -> Iterator[Event]:
        """What happens from now on, as it happens: newer reports, and commands whose state changes.

        It begins with a report. A reader that was slow gets the newest report, and every command.
        """
        since: Optional[str] = None
        newest: Optional[Snapshot] = None
        while True:
            after = 0 if newest is None else newest.seq
            since, events = self._run(self._talk.events(since, after))
            for event in events:
                # Each answer has the newest report, also where only a command has changed.
                if event.snapshot is not None and event.snapshot == newest:
                    continue
                newest = event.snapshot or newest
                yield event

    def maze(self) -> Maze:
        """The maze that the robot is in: its blocks, its start and its goals."""
        return self._run(self._talk.maze())

    def wait_until(
        self, condition: Callable[[Sensors], object], timeout: Optional[float] = None
    ) -> Sensors:
        """Waits until a condition holds: `robot.wait_until(lambda sensor: sensor.front < 60)`."""
        return self._run(self._talk.wait_until(condition, timeout))

    def wait(self, seconds: float) -> None:
        """Lets the robot go on for so long. Unlike in time.sleep(), it knows that you are there."""
        self._run(self._talk.wait(seconds))

    @property
    def commands(self) -> List[Command]:
        """The log: every command that the robot's host keeps, oldest first."""
        return self._run(self._talk.log())

    # --- the end ---

    def close(self) -> None:
        """Leaves the robot as it is; this object can do nothing more."""
        self._talk.is_closed = True

    def __enter__(self) -> Robot:
        return self

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        _error: Optional[BaseException],
        _trace: Optional[TracebackType],
    ) -> None:
        """Stops the robot if it would drive on by itself, and leaves it."""
        try:
            if self._talk.drives_on and not self._talk.is_closed:
                self.stop()
        except RobotError:
            # What went wrong first is what the reader has to know.
            if kind is None:
                raise
        finally:
            self.close()

    def __repr__(self) -> str:
        address = self._talk.address
        return f"<Robot {address.origin}/r/{address.id}>"

    def _do(self, action: Action) -> Command:
        return self._run(self._talk.do(action))

    def _read(self, name: str) -> Snapshot:
        return self._run(self._talk.read(name))

    def _run(self, talk: Talk[T]) -> T:
        return run(talk, self._line)
