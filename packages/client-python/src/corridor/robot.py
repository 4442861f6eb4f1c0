"""The robot for scripts without asyncio."""

from __future__ import annotations

from types import TracebackType
from typing import TYPE_CHECKING, Callable, Iterator, List, Optional, Type

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
from .errors import RobotError
from .transport import HttpTransport, run
from .live_sensor import LiveSensor
from .other_names import no_attribute
from .pairing import pair
from .reports import Command, Event, Maze, Sensors, Snapshot
from .requests import T, Exchange
from .protocol import RobotProtocol


class Robot:
    """A robot on the network, simulated or physical. Each method waits until the robot has finished.

    A failed request is repeated with the same idempotency key and its age, so that the robot never
    executes a command twice or late. Every method that sends a request may raise `NotAuthorisedError`,
    `RobotGoneError`, `NoAnswerError` or `ClosedError`.

    Used as `with Robot(ADDRESS) as robot:`, it stops an endless motion at the end of the block.

    Args:
        address: `http://HOST/r/ID#KEY`, as the robot's page shows it under Remote.
        key: the key, if the address does not contain it.
        answer_timeout: timeout for responses of the host in seconds, including retries.
        finish_timeout: timeout for the robot to finish a command in seconds.
        ttl: time to live: seconds within which a command must start, or it ends as `expired`. 0.2 to 60.
            `None` is the host's default, 10. `stop()` always has 10. It must be longer than the round
            trip to the host.
        name: name of this script, which the robot's owner sees. At most 40 characters are displayed.

    Raises:
        AddressError: the address is incomplete, or another server responds there.
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
        self._protocol = RobotProtocol(where, answer_timeout, finish_timeout, check_ttl(ttl), name=name)
        self._transport = HttpTransport()
        self._sensor = LiveSensor(self._read)
        self._run(self._protocol.check_access())

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
        """Connects by a pairing code, and waits until the robot's owner accepts this script.

        Use `robot.address`, which has its own key, to connect again without a code.

        Args:
            service: the origin of the robot's page, such as `http://HOST`.
            code: the 8 letters that the page shows under Remote. Spaces and lower case are accepted.
            answer_timeout: as in `Robot`.
            finish_timeout: as in `Robot`.
            ttl: as in `Robot`.
            name: as in `Robot`.

        Raises:
            PairingError: the code is wrong or has expired, or the owner refused.
        """
        address = run(pair(service, code, name, answer_timeout), HttpTransport())
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
        return self._protocol.address.whole

    # --- driving ---

    def forward(
        self, distance: Optional[float] = None, *, until: Optional[Until] = None
    ) -> Command:
        """Drives forward, and waits for the end; without an end, until the next command.

        With `until`, the robot stops exactly when one of the conditions is true. Without a distance
        and conditions it returns once the robot has started. The robot stops 3 s after the last
        request of this script.

        Args:
            distance: cm, -25600 to 25600. Negative is backward. `None`: endless.
            until: a condition, such as `{"sensor": "front", "is": "<=", "than": 60}` or
                `{"goal": True}`, or a list of at most 200. Not together with a distance.

        Returns:
            The record. It is falsy if a wall ended the move.

        Raises:
            CommandError: the distance is out of its range, or the host refused the command.
            CommandEndedError: the command was cancelled, superseded, or could not start in time.
        """
        return self._do(go_forward(distance, until))

    def reverse(
        self, distance: Optional[float] = None, *, until: Optional[Until] = None
    ) -> Command:
        """Drives backward, as `forward` drives forward.

        Args:
            distance: cm, -25600 to 25600. Negative is forward. `None`: endless.
            until: as in `forward`.

        Returns:
            The record. It is falsy if a wall ended the move.

        Raises:
            CommandError: as in `forward`.
            CommandEndedError: as in `forward`.
        """
        return self._do(go_reverse(distance, until))

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
        """Drives 50 cm forward, turns left, drives 60 cm out of the junction, and waits for the end.

        Returns:
            The record.

        Raises:
            CommandError: as in `forward`.
            CommandEndedError: as in `forward`.
        """
        return self._do(plain("delayed left 90"))

    def delayed_right(self) -> Command:
        """Drives 50 cm forward, turns right, drives 60 cm out of the junction, and waits for the end.

        Returns:
            The record.

        Raises:
            CommandError: as in `forward`.
            CommandEndedError: as in `forward`.
        """
        return self._do(plain("delayed right 90"))

    def drive(
        self,
        left: float,
        right: float,
        milliseconds: Optional[float] = None,
        *,
        until: Optional[Until] = None,
    ) -> Command:
        """Sets the power of the two wheels, for a time or until a condition, and waits for the end.

        Without an end it returns once the robot has started, and the robot stops half a second later
        unless another `drive` follows.

        Args:
            left: power of the left wheel, -1 to 1. Negative is backward.
            right: power of the right wheel, -1 to 1.
            milliseconds: 1 to 60000. `None`: half a second, and no waiting.
            until: as in `forward`. Not together with milliseconds.

        Returns:
            The record. It is falsy if a wall ended the drive.

        Raises:
            CommandError: as in `forward`.
            CommandEndedError: as in `forward`.
        """
        return self._do(power_wheels(left, right, milliseconds, until))

    def stop(self) -> Command:
        """Stops at once: cancels the running command and all waiting ones, from every script.

        Returns:
            The record, once the robot has stopped.
        """
        return self._run(self._protocol.stop())

    def reset(self) -> Command:
        """Puts the robot at its start, which begins a new run, and ends all earlier commands.

        A robot accepts one reset a second; this method waits for its turn. It raises
        `CommandError` with the code `refused` if the robot's owner has forbidden it, or if the
        robot cannot do it, such as a physical robot: catch it to continue from where the robot is.

        Returns:
            The record, once the robot is at its start.
        """
        return self._do(plain("reset"))

    # --- reading and waiting ---

    @property
    def sensor(self) -> LiveSensor:
        """The four distances, read on access: `robot.sensor.front`."""
        return self._sensor

    @property
    def goal_reached(self) -> bool:
        """Whether the robot has reached a goal since its start. Read on access, like `sensor`."""
        return self._read("goal_reached").goal_reached

    @property
    def bumps(self) -> int:
        """Number of bumps since the robot's start. Read on access, like `sensor`."""
        return self._read("bumps").bumps

    def sensors(self) -> Sensors:
        """Reads the four range sensors.

        Returns:
            The distances of one tick. The object does not change later.
        """
        return self.snapshot().sensors

    def snapshot(self) -> Snapshot:
        """Reads everything that the robot reports.

        Returns:
            The newest snapshot. It is never from before the end of the last command.
        """
        return self._run(self._protocol.next_snapshot())

    def snapshots(self) -> Iterator[Snapshot]:
        """Follows the robot until the loop ends: `for snapshot in robot.snapshots():`.

        Returns:
            About 20 snapshots a second. A slow reader gets only the newest.
        """
        while True:
            yield self._run(self._protocol.next_snapshot(1.0))

    def events(self) -> Iterator[Event]:
        """Follows the robot and the commands of all scripts, until the loop ends.

        Returns:
            Events in order. The first one is a snapshot. A slow reader gets the newest snapshot, and every
            state of a command.
        """
        since: Optional[str] = None
        newest: Optional[Snapshot] = None
        while True:
            after = 0 if newest is None else newest.seq
            since, events = self._run(self._protocol.events(since, after))
            for event in events:
                # Each response repeats the newest snapshot, even if only a command has changed.
                if event.snapshot is not None and event.snapshot == newest:
                    continue
                newest = event.snapshot or newest
                yield event

    def maze(self) -> Maze:
        """Reads the robot's maze.

        Returns:
            Its blocks, its start and its goals.

        Raises:
            NoMazeError: the robot's host does not publish its maze.
        """
        return self._run(self._protocol.maze())

    def wait_until(
        self, condition: Callable[[Sensors], object], timeout: Optional[float] = None
    ) -> Sensors:
        """Waits until a condition is true: `robot.wait_until(lambda sensor: sensor.front < 60)`.

        The robot continues its motion.

        Args:
            condition: called with each new reading.
            timeout: in seconds. `None`: `finish_timeout` of the robot.

        Returns:
            The reading for which the condition is true.

        Raises:
            NoAnswerError: the condition did not become true in time.
        """
        return self._run(self._protocol.wait_until(condition, timeout))

    def wait(self, seconds: float) -> None:
        """Waits while the robot continues its motion.

        Unlike `time.sleep`, it sends a request each second, so that the robot does not stop.

        Args:
            seconds: duration.
        """
        self._run(self._protocol.wait(seconds))

    @property
    def commands(self) -> List[Command]:
        """The log: the record of every command that the robot's host stores, oldest first."""
        return self._run(self._protocol.log())

    # --- the end ---

    def close(self) -> None:
        """Closes this object. The robot continues its motion."""
        self._protocol.is_closed = True

    def __enter__(self) -> Robot:
        return self

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        _error: Optional[BaseException],
        _trace: Optional[TracebackType],
    ) -> None:
        """Stops an endless motion, and closes this object."""
        try:
            if self._protocol.has_endless_motion and not self._protocol.is_closed:
                self.stop()
        except RobotError:
            # Do not hide the first error.
            if kind is None:
                raise
        finally:
            self.close()

    def __repr__(self) -> str:
        address = self._protocol.address
        return f"<Robot {address.origin}/r/{address.id}>"

    if not TYPE_CHECKING:
        # Type checkers would accept every name.
        def __getattr__(self, name):
            raise no_attribute(self, name)

    def _do(self, action: Action) -> Command:
        return self._run(self._protocol.execute(action))

    def _read(self, name: str) -> Snapshot:
        return self._run(self._protocol.snapshot_for(name))

    def _run(self, exchange: Exchange[T]) -> T:
        return run(exchange, self._transport)
