"""What the robot's host says: readings, snapshots and the records of commands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, NamedTuple, Optional, Tuple, Union

ENDINGS = ("completed", "collided", "cancelled", "superseded", "expired")


class Cell(NamedTuple):
    """A square of the maze, 100 cm wide, counted from 0 at the top left."""

    column: int
    row: int


@dataclass(frozen=True)
class Sensors:
    """The distance to the next wall on each side, in cm from the robot's centre, all of one tick."""

    front: float
    right: float
    back: float
    left: float


@dataclass(frozen=True)
class Pose:
    """Where the robot's centre is, in cm, and where it faces: degrees clockwise from north."""

    x: float
    y: float
    heading: float

    @property
    def cell(self) -> Cell:
        """The cell in which the centre is."""
        return Cell(int(self.x // _CELL), int(self.y // _CELL))


@dataclass(frozen=True)
class Snapshot:
    """All that the robot reports, of one tick."""

    #: number of this report; it rises
    seq: int
    #: 1/60 s since the robot was put at its start
    tick: int
    #: running, paused (it stands still) or gone (its page is closed)
    state: str
    #: who drives: me, program or remote
    driver: str
    sensors: Sensors
    pose: Pose
    #: the action that moves it now, such as forward or stop
    motion: str
    #: number of walls that it has met since its start
    bumps: int
    #: whether it touches a wall now
    bumping: bool
    #: whether it has reached a goal since its start
    goal_reached: bool
    #: the deciding line of its program, counted from 0, or "default" for "otherwise"
    line: Union[int, str, None]
    #: seq of the remote command that runs
    command: Optional[int]


@dataclass(frozen=True)
class Command:
    """The record of one command. It counts as true unless a wall was in the way."""

    seq: int
    action: str
    #: accepted, delivered, started, or one of the endings completed, collided, cancelled, ...
    state: str
    reason: Optional[str]
    #: cm driven by this command
    distance: Optional[float]
    #: where the robot was when the command ended
    pose: Optional[Pose]
    #: the whole request, with its numbers
    request: Mapping[str, Any]

    @property
    def ended(self) -> bool:
        """Whether its life is over."""
        return self.state in ENDINGS

    @property
    def collided(self) -> bool:
        """Whether a wall was in the way."""
        return self.state == "collided"

    def __bool__(self) -> bool:
        return not self.collided


@dataclass(frozen=True)
class Event:
    """One thing that happened. `kind` says what, and which of the two fields is set."""

    #: snapshot (a newer report), command (the state of one changed) or gap (events were missed)
    kind: str
    snapshot: Optional[Snapshot] = None
    command: Optional[Command] = None


@dataclass(frozen=True)
class Start:
    """Where the robot starts, and where it faces: north, east, south or west."""

    cell: Cell
    heading: str


@dataclass(frozen=True)
class Maze:
    """The maze of a robot. A cell is 100 cm wide."""

    name: str
    #: one text for each row, from the top: `#` is a block, `.` is open
    blocks: Tuple[str, ...]
    start: Start
    goals: Tuple[Cell, ...]

    @property
    def columns(self) -> int:
        """How many cells a row has."""
        return len(self.blocks[0])

    @property
    def rows(self) -> int:
        """How many rows there are."""
        return len(self.blocks)

    def is_open(self, column: int, row: int) -> bool:
        """Whether a robot can be in this cell; outside of the maze it cannot."""
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
