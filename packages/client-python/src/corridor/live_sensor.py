"""`robot.sensor.front`: readings on demand."""

from __future__ import annotations

from typing import TYPE_CHECKING, Callable

from .other_names import no_attribute
from .reports import Snapshot


class LiveSensor:
    """`robot.sensor`: the four distances in cm from the robot's centre, read on access.

    Different sides that are read within 0.1 s come from the same snapshot, so that the readings of one
    decision are consistent. Reading a side again, calling any other method, or 0.1 s start a new
    snapshot. `robot.sensors()` returns four readings that do not change.
    """

    def __init__(self, read: Callable[[str], Snapshot]) -> None:
        self._snapshot_for = read

    @property
    def front(self) -> float:
        """cm to the wall in front."""
        return self._snapshot_for("front").sensors.front

    @property
    def right(self) -> float:
        """cm to the wall at the right."""
        return self._snapshot_for("right").sensors.right

    @property
    def back(self) -> float:
        """cm to the wall behind."""
        return self._snapshot_for("back").sensors.back

    @property
    def left(self) -> float:
        """cm to the wall at the left."""
        return self._snapshot_for("left").sensors.left

    def __repr__(self) -> str:
        return repr(self._snapshot_for("all").sensors)

    if not TYPE_CHECKING:

        def __getattr__(self, name):
            raise no_attribute(self, name)
