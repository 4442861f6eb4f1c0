"""What the robot's host says: readings, snapshots and the records of commands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, NamedTuple, Optional, Tuple, Union

ENDINGS = ("completed", "collided", "cancelled", "superseded", "expired")


class Cell(NamedTuple):
    """A square of the maze, 100 cm wide, counted from 0 at the top left."""

    #: from the left
    column: int
    #: from the top
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
        """The square of the maze in which the centre is."""
        return Cell(int(self.x // _CELL), int(self.y // _CELL))


@dataclass(frozen=True)
class Snapshot:
    """Everything that the robot reports, of one tick."""

    #: number of this snapshot; it rises
    seq: int
    #: 1/60 s since the robot was put at its start
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
    #: number of walls that the robot has met since its start
    bumps: int
    #: whether the robot touches a wall now
    bumping: bool
    #: whether the robot has reached a goal since its start
    goal_reached: bool
    #: the deciding line of its program, counted from 0, `"default"` for "otherwise", or `None`
    line: Union[int, str, None]
    #: `seq` of the command that runs, or `None`
    command: Optional[int]


@dataclass(frozen=True)
class Command:
    """The record of one command. It counts as true unless a wall was in the way."""

    #: number of the command at its robot: 1, 2, 3
    seq: int
    #: such as `move` or `left 90`
    action: str
    #: `accepted`, `delivered`, `started`, or an ending: `completed`, `collided`, `cancelled`,
    #: `superseded` or `expired`
    state: str
    #: why it ended as it did, or `None`
    reason: Optional[str]
    #: cm driven by this command, never below 0; `None` until it has ended
    distance: Optional[float]
    #: where the robot was when the command ended; `None` before
    pose: Optional[Pose]
    #: the whole request, with its numbers
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
    """One thing that happened. `kind` says what, and which of the two fields is set."""

    #: `snapshot` (a newer one), `command` (the state of one changed) or `gap` (events were missed)
    kind: str
    #: set where `kind` is `snapshot`
    snapshot: Optional[Snapshot] = None
    #: set where `kind` is `command`
    command: Optional[Command] = None


@dataclass(frozen=True)
class Start:
    """Where the robot starts, and where it faces."""

    #: the square
    cell: Cell
    #: `north`, `east`, `south` or `west`
    heading: str


@dataclass(frozen=True)
class Maze:
    """The maze of a robot. A square is 100 cm wide."""

    #: its title
    name: str
    #: one text for each row, from the top: `#` is a block, `.` is open
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


# What a newer host adds is left aside; what is missing is told as an answer of something else.


def read_snapshot(answer: Any) -> Snapshot:
    return Snapshot(
        seq=answer["seq"],
        tick=answer["tick"],
        state=answer["state"],
        driver=answer["driver"],
        sensors=Sensors(**{name: answer["sensors"][name] for name in _SENSORS}),
        pose=_pose(answer["pose"]),
        motion=answer["motion"],
        bumps=answer["bumps"],
        bumping=answer["bumping"],
        goal_reached=answer["goalReached"],
        line=answer["line"],
        command=answer["command"],
    )


def read_command(answer: Any) -> Command:
    return Command(
        seq=answer["seq"],
        action=answer["action"],
        state=answer["state"],
        reason=answer["reason"],
        distance=answer["distance"],
        pose=None if answer["pose"] is None else _pose(answer["pose"]),
        request=answer.get("command") or {"action": answer["action"]},
    )


def read_events(page: Any) -> Tuple[Event, ...]:
    """What a page of events tells, the snapshot before the endings that it belongs to."""
    gap = () if page["gap"] is None else (Event("gap"),)
    snapshot = page["snapshot"]
    seen = () if snapshot is None else (Event("snapshot", snapshot=read_snapshot(snapshot)),)
    states = (Event("command", command=read_command(each["record"])) for each in page["states"])
    return (*gap, *seen, *states)


def read_maze(answer: Any) -> Maze:
    start = answer["start"]
    return Maze(
        name=answer["name"],
        blocks=tuple(answer["blocks"]),
        start=Start(Cell(start["column"], start["row"]), start["heading"]),
        goals=tuple(Cell(goal["column"], goal["row"]) for goal in answer["goals"]),
    )


def _pose(answer: Any) -> Pose:
    return Pose(answer["x"], answer["y"], answer["heading"])


_CELL = 100
_SENSORS = ("front", "right", "back", "left")
