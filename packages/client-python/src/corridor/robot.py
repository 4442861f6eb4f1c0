"""A robot that a script drives. Every method waits until the robot has done it."""

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
from .transport import Line, run
from .live_sensor import LiveSensor
from .pairing import pair
from .reports import Command, Event, Maze, Sensors, Snapshot
from .requests import T, Talk
from .protocol import RobotTalk


class Robot:
    """A robot on the network, in a page or on a table. Each method waits until the robot has done it.

    A failed request is sent again, with the same idempotency key and its age, so no command is done
    twice or late. Every method that asks the robot's host raises `NotAuthorisedError`, `RobotGoneError`,
    `NoAnswerError` or `ClosedError` where it does not get what it asked for.

    Used as `with Robot(ADDRESS) as robot:`, it stops a robot that would drive on at the end of the block.

    Args:
        address: `http://HOST/r/ID#KEY`, as the robot's page shows it under Remote.
        key: the key, where the address comes without it.
        answer_timeout: seconds that the host may stay silent, reconnecting included.
        finish_timeout: seconds that the robot may take for one command.
        ttl: seconds within which a command must start, or it ends as `expired`: 0.2 to 60. `None` is
            the host's default, 10. `stop()` always has 10. It must be longer than the way to the host
            and back.
        name: what this script calls itself, for the robot's owner. 40 characters are shown.

    Raises:
        AddressError: the address is not complete, or leads to something else.
        CommandError: `ttl` is out of its range.
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
        """Connects by a code of 8 letters, and waits until the robot's owner accepts this script.

        `robot.address` has a key of its own and works the next time without a code.

        Args:
            service: where the robot's page is, such as `http://HOST`.
            code: the code that the page shows under Remote. Spaces and small letters are accepted.
            answer_timeout: as in `Robot`.
            finish_timeout: as in `Robot`.
            ttl: as in `Robot`.
            name: as in `Robot`. The page shows it in its question to the owner.

        Raises:
            PairingError: the code is wrong or over, or the owner refused.
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
        """The whole address, with its key. Keep it private."""
        return self._talk.address.whole

    # --- measured: they end by themselves, or at a wall ---

    def forward(self, distance: Optional[float] = None) -> Command:
        """Drives forward, and waits for the end; without a distance, until another command comes.

        Without a distance it returns once the robot has started. The robot stops by itself 3 s after
        the last request of this script.

        Args:
            distance: cm, -25600 to 25600. Negative is backward. `None`: no end.

        Returns:
            The record. It counts as false where a wall ended the move.

        Raises:
            CommandError: the distance is out of its range, or the host refused the command.
            CommandEndedError: the command was cancelled, superseded, or could not start in time.
        """
        return self._do(go_forward(distance))

    def reverse(self, distance: Optional[float] = None) -> Command:
        """Drives backward, as `forward` drives forward.

        Args:
            distance: cm, -25600 to 25600. Negative is forward. `None`: no end.

        Returns:
            The record. It counts as false where a wall ended the move.

        Raises:
            CommandError: as in `forward`.
            CommandEndedError: as in `forward`.
        """
        return self._do(go_reverse(distance))

    def left(self, degrees: float = 90) -> Command:
        """Turns left on the spot, and waits for the end.

        Args:
            degrees: at most 3600.

        Returns:
            The record.

        Raises:
            CommandError: as in `forward`.
            CommandEndedError: as in `forward`.
        """
        return self._do(turn_left(degrees))

    def right(self, degrees: float = 90) -> Command:
        """Turns right on the spot, and waits for the end.

        Args:
            degrees: at most 3600.

        Returns:
            The record.

        Raises:
            CommandError: as in `forward`.
            CommandEndedError: as in `forward`.
        """
        return self._do(turn_right(degrees))

    def turn(self, degrees: float) -> Command:
        """Turns on the spot, and waits for the end.

        Args:
            degrees: -3600 to 3600. Positive is right, negative is left.

        Returns:
            The record.

        Raises:
            CommandError: as in `forward`.
            CommandEndedError: as in `forward`.
        """
        return self._do(turn_by(degrees))

    def delayed_left(self) -> Command:
        """Drives on 50 cm, turns left, drives 60 cm out of the junction, and waits for the end.

        Returns:
            The record.

        Raises:
            CommandError: as in `forward`.
            CommandEndedError: as in `forward`.
        """
        return self._do(plain("delayed left 90"))

    def delayed_right(self) -> Command:
        """Drives on 50 cm, turns right, drives 60 cm out of the junction, and waits for the end.

        Returns:
            The record.

        Raises:
            CommandError: as in `forward`.
            CommandEndedError: as in `forward`.
        """
        return self._do(plain("delayed right 90"))

    def drive(self, left: float, right: float, milliseconds: Optional[float] = None) -> Command:
        """Sets the power of the two wheels, for a time, and waits for the end.

        Without a time it returns once the robot has started, and the robot stops by itself half a
        second later unless another `drive` follows.

        Args:
            left: power of the left wheel, -1 to 1. Negative is backward.
            right: power of the right wheel, -1 to 1.
            milliseconds: 1 to 60000. `None`: half a second, and no waiting.

        Returns:
            The record. It counts as false where a wall ended the drive.

        Raises:
            CommandError: as in `forward`.
            CommandEndedError: as in `forward`.
        """
        return self._do(power_wheels(left, right, milliseconds))

    def stop(self) -> Command:
        """Stops at once: cancels the running command and all waiting ones, from every script.

        Returns:
            The record, once the robot stands.
        """
        return self._run(self._talk.stop())

    # --- reading and waiting ---

    @property
    def sensor(self) -> LiveSensor:
        """The four distances, read when they are asked for: `robot.sensor.front`."""
        return self._sensor

    @property
    def goal_reached(self) -> bool:
        """Whether the robot has reached a goal since its start. It is read like a side of `sensor`."""
        return self._read("goal_reached").goal_reached

    @property
    def bumps(self) -> int:
        """Number of walls that the robot has met since its start. It is read like a side of `sensor`."""
        return self._read("bumps").bumps

    def sensors(self) -> Sensors:
        """Reads the four distances.

        Returns:
            The distances of one tick. The object does not change later.
        """
        return self.snapshot().sensors

    def snapshot(self) -> Snapshot:
        """Reads everything that the robot reports.

        Returns:
            The newest snapshot. It is never from before the end of the last command.
        """
        return self._run(self._talk.look())

    def snapshots(self) -> Iterator[Snapshot]:
        """Follows the robot without an end: `for snapshot in robot.snapshots():`.

        Returns:
            One snapshot after the other, about 20 a second. A slow reader gets the newest each time.
        """
        while True:
            yield self._run(self._talk.look(1.0))

    def events(self) -> Iterator[Event]:
        """Follows the robot and the commands of all scripts, without an end.

        Returns:
            Events in their order. The first one is a snapshot. A slow reader gets the newest snapshot,
            and every change of a command.
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
        """Reads the maze that the robot is in.

        Returns:
            Its blocks, its start and its goals.

        Raises:
            NoMazeError: the robot's host does not publish its maze.
        """
        return self._run(self._talk.maze())

    def wait_until(
        self, condition: Callable[[Sensors], object], timeout: Optional[float] = None
    ) -> Sensors:
        """Waits until a condition holds: `robot.wait_until(lambda sensor: sensor.front < 60)`.

        The robot goes on with what it does.

        Args:
            condition: is called with each new reading.
            timeout: seconds to wait at most. `None`: `finish_timeout` of the robot.

        Returns:
            The reading for which the condition holds.

        Raises:
            NoAnswerError: the condition did not hold in time.
        """
        return self._run(self._talk.wait_until(condition, timeout))

    def wait(self, seconds: float) -> None:
        """Waits, and lets the robot go on with what it does.

        Unlike `time.sleep`, it sends a request each second, so that the robot does not stop.

        Args:
            seconds: how long.
        """
        self._run(self._talk.wait(seconds))

    @property
    def commands(self) -> List[Command]:
        """The log: the record of every command that the robot's host stores, oldest first."""
        return self._run(self._talk.log())

    # --- the end ---

    def close(self) -> None:
        """Ends the use of this object. The robot goes on with what it does."""
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
