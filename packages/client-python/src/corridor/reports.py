"""The values that a robot's host sends: readings, snapshots, records of commands, events, mazes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional, Tuple, Union

from .other_names import no_attribute

ENDINGS = ("completed", "collided", "cancelled", "superseded", "expired")


class Cell(NamedTuple):
    """A square of the maze, 100 cm wide."""

    #: from the left, from 0
    column: int
    #: from the top, from 0
    row: int


@dataclass(frozen=True)
class Sensors:
    """The distance to the next wall on each side, in cm from the robot's centre, all of one tick."""

    #: cm to the wall in front
    front: float
    #: cm to the wall at the right
    right: float
    #: cm to the wall behind
    back: float
    #: cm to the wall at the left
    left: float

    if not TYPE_CHECKING:

        def __getattr__(self, name):
            raise no_attribute(self, name)


@dataclass(frozen=True)
class Pose:
    """Where the robot's centre is, in cm, and where it faces: degrees clockwise from north."""

    #: cm from the left edge of the maze
    x: float
    #: cm from the top edge of the maze
    y: float
    #: degrees clockwise from north, from 0 up to 360
    heading: float

    @property
    def cell(self) -> Cell:
        """The square that contains the centre."""
        return Cell(int(self.x // _CELL), int(self.y // _CELL))


@dataclass(frozen=True)
class Snapshot:
    """Everything that the robot reports, of one tick."""

    #: number of this snapshot, increasing
    seq: int
    #: ticks of 1/60 s since the robot was placed at its start
    tick: int
    #: `running`, `paused` (the robot stands still) or `gone` (its page is closed)
    state: str
    #: who drives: `me`, `program` or `remote`
    driver: str
    #: the four distances
    sensors: Sensors
    #: where the robot is
    pose: Pose
    #: the action that moves the robot now, such as `forward` or `stop`
    motion: str
    #: number of bumps since the robot's start
    bumps: int
    #: whether the robot touches a wall now
    bumping: bool
    #: whether the robot has reached a goal since its start
    goal_reached: bool
    #: the program line that decides, from 0, `"default"` for the default action, or `None`
    line: Union[int, str, None]
    #: `seq` of the running command, or `None`
    command: Optional[int]

    if not TYPE_CHECKING:

        def __getattr__(self, name):
            raise no_attribute(self, name)


@dataclass(frozen=True)
class Command:
    """The record of one command. It is falsy if a wall ended the command."""

    #: number of the command of its robot: 1, 2, 3, ...
    seq: int
    #: such as `move` or `left 90`
    action: str
    #: `accepted`, `delivered`, `started`, or an ending: `completed`, `collided`, `cancelled`,
    #: `superseded` or `expired`
    state: str
    #: why it ended, as a sentence, or `None`
    reason: Optional[str]
    #: cm driven by this command, 0 or more; `None` before its end
    distance: Optional[float]
    #: where the robot was when the command ended; `None` before that
    pose: Optional[Pose]
    #: the command with its parameters
    request: Mapping[str, Any]

    @property
    def ended(self) -> bool:
        """Whether the command has ended."""
        return self.state in ENDINGS

    @property
    def collided(self) -> bool:
        """Whether a wall ended the command."""
        return self.state == "collided"

    def __bool__(self) -> bool:
        return not self.collided


@dataclass(frozen=True)
class Event:
    """An event. `kind` names its type, and determines which of the two fields is set."""

    #: `snapshot` (a newer one), `command` (a command has a new state) or `gap` (events were missed)
    kind: str
    #: set if `kind` is `snapshot`
    snapshot: Optional[Snapshot] = None
    #: set if `kind` is `command`
    command: Optional[Command] = None


@dataclass(frozen=True)
class Start:
    """Where the robot starts, and its direction."""

    #: the square
    cell: Cell
    #: `north`, `east`, `south` or `west`
    heading: str


@dataclass(frozen=True)
class Maze:
    """The maze of a robot. A square is 100 cm wide."""

    #: its title
    name: str
    #: one string per row, from the top: `#` is a block, `.` is open
    blocks: Tuple[str, ...]
    #: where the robot starts
    start: Start
    #: the squares that are goals
    goals: Tuple[Cell, ...]

    @property
    def columns(self) -> int:
        """Number of squares in a row."""
        return len(self.blocks[0])

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(self.blocks)

    def is_open(self, column: int, row: int) -> bool:
        """Whether a square is open, so that a robot can be there.

        Args:
            column: from 0 at the left.
            row: from 0 at the top.

        Returns:
            False for a block, and outside of the maze.
        """
        is_inside = 0 <= column < self.columns and 0 <= row < self.rows
        return is_inside and self.blocks[row][column] != "#"


# Readers ignore unknown fields. A missing field raises an error: another server has responded.


def read_snapshot(json: Any) -> Snapshot:
    return Snapshot(
        seq=json["seq"],
        tick=json["tick"],
        state=json["state"],
        driver=json["driver"],
        sensors=Sensors(**{name: json["sensors"][name] for name in _SENSORS}),
        pose=_pose(json["pose"]),
        motion=json["motion"],
        bumps=json["bumps"],
        bumping=json["bumping"],
        goal_reached=json["goalReached"],
        line=json["line"],
        command=json["command"],
    )


def read_command(json: Any) -> Command:
    return Command(
        seq=json["seq"],
        action=json["action"],
        state=json["state"],
        reason=json["reason"],
        distance=json["distance"],
        pose=None if json["pose"] is None else _pose(json["pose"]),
        request=json.get("command") or {"action": json["action"]},
    )


def read_events(page: Any) -> Tuple[Event, ...]:
    """The events of a page; the snapshot precedes the states."""
    gap = () if page["gap"] is None else (Event("gap"),)
    snapshot = page["snapshot"]
    snapshots = () if snapshot is None else (Event("snapshot", snapshot=read_snapshot(snapshot)),)
    states = (Event("command", command=read_command(each["record"])) for each in page["states"])
    return (*gap, *snapshots, *states)


def read_maze(json: Any) -> Maze:
    start = json["start"]
    return Maze(
        name=json["name"],
        blocks=tuple(json["blocks"]),
        start=Start(Cell(start["column"], start["row"]), start["heading"]),
        goals=tuple(Cell(goal["column"], goal["row"]) for goal in json["goals"]),
    )


def _pose(json: Any) -> Pose:
    return Pose(json["x"], json["y"], json["heading"])


_CELL = 100
_SENSORS = ("front", "right", "back", "left")
