"""What the robot's host says: readings, snapshots and the records of commands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Optional

ENDINGS = ("completed", "collided", "cancelled", "superseded", "expired")


@dataclass(frozen=True)
class Sensors:
    """How far it is to the next wall, in cm from the robot's centre."""

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


@dataclass(frozen=True)
class Snapshot:
    """All that the robot reports at one moment."""

    seq: int
    tick: int
    #: running, paused (it stands still), gone (its page is away)
    state: str
    #: me, program, remote
    driver: str
    sensors: Sensors
    pose: Pose
    motion: str
    bumps: int
    bumping: bool
    goal_reached: bool
    #: number of the remote command that runs
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


def _pose(answer: Any) -> Pose:
    return Pose(answer["x"], answer["y"], answer["heading"])


_SENSORS = ("front", "right", "back", "left")
