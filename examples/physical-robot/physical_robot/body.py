"""The robot's body, simulated: two wheels, four range finders and a bumper.

Replace only this module for a physical robot: `drive` sets the motors, `ranges` reads the range
finders, and `pose` is the odometry of the wheel encoders and a gyroscope.

`drive` is called 50 times per second while the robot moves. It is not called while the robot is
stopped, or after this program has crashed. The motors must therefore stop if there is no call for
0.1 s; implement this in the motor controller. The simulated wheels turn only during a call.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Dict, List

#: Width of one character of the room's plan, in cm.
CELL = 100.0
RADIUS = 25.0
TRACK = 40.0
#: Directions of the range finders relative to the front, in degrees clockwise.
RANGE_FINDERS = {"front": 0, "right": 90, "back": 180, "left": 270}


@dataclass
class Pose:
    """cm to the right and down from the corner of the room, degrees clockwise from north."""

    x: float
    y: float
    heading: float


class SimulatedBody:
    """A body in a room of blocks. A wall stops it."""

    def __init__(self, plan: List[str]) -> None:
        """`plan`: rows of `#` for a block, `.` for floor, `G` for a goal and `S` for the start.

        The robot starts at `S`, or on the first floor cell if there is no `S`, and faces north.
        """
        self._plan = plan
        self.reset()

    def reset(self) -> None:
        """Puts the body at its start. Only a simulated body can do this."""
        plan = self._plan
        start = "S" if any("S" in cells for cells in plan) else "."
        row = next(index for index, cells in enumerate(plan) if start in cells)
        self.pose = Pose((plan[row].index(start) + 0.5) * CELL, (row + 0.5) * CELL, 0.0)
        self.bumping = False
        self.bumps = 0

    def drive(self, left: float, right: float, seconds: float) -> float:
        """Turns the wheels with the given speeds in cm/s, for at most 0.1 s.

        Returns the driven distance in cm, at least 0. The motors stop 0.1 s after the last call.
        """
        turned = math.degrees((left - right) / TRACK * seconds)
        distance = (left + right) / 2 * seconds
        middle = math.radians(self.pose.heading + turned / 2)
        self.pose.heading = (self.pose.heading + turned) % 360
        share = self._free_share(distance, middle)
        self.pose.x += math.sin(middle) * distance * share
        self.pose.y -= math.cos(middle) * distance * share
        touches = share < 1
        if touches and not self.bumping:
            self.bumps += 1
        self.bumping = touches
        return abs(distance) * share

    @property
    def has_goal(self) -> bool:
        """Whether the room contains a goal that the floor sensor can detect."""
        return any("G" in cells for cells in self._plan)

    @property
    def at_goal(self) -> bool:
        """Whether the whole robot stands in a goal cell."""
        # A robot that touches the wall of the cell stands in it, in spite of rounding.
        reach = RADIUS - 0.1
        cells = {
            (math.floor((self.pose.x + dx) / CELL), math.floor((self.pose.y + dy) / CELL))
            for dx in (-reach, reach)
            for dy in (-reach, reach)
        }
        column, row = next(iter(cells))
        is_inside = len(cells) == 1 and not self._is_block(column, row)
        return is_inside and self._plan[row][column] == "G"

    def ranges(self) -> Dict[str, float]:
        """Distances in cm from the robot's centre to the next wall in four directions."""
        return {name: round(self._range(angle), 2) for name, angle in RANGE_FINDERS.items()}

    def _free_share(self, distance: float, heading: float) -> float:
        """The share of a distance that the robot can drive without a collision, from 0 to 1."""
        free, blocked = 0.0, 1.0
        if self._is_free(distance, heading):
            return 1.0
        for _ in range(12):
            share = (free + blocked) / 2
            if self._is_free(distance * share, heading):
                free = share
            else:
                blocked = share
        return free

    def _is_free(self, distance: float, heading: float) -> bool:
        x = self.pose.x + math.sin(heading) * distance
        y = self.pose.y - math.cos(heading) * distance
        for row in range(int((y - RADIUS) // CELL), int((y + RADIUS) // CELL) + 1):
            for column in range(int((x - RADIUS) // CELL), int((x + RADIUS) // CELL) + 1):
                if not self._is_block(column, row):
                    continue
                nearest_x = min(max(x, column * CELL), (column + 1) * CELL)
                nearest_y = min(max(y, row * CELL), (row + 1) * CELL)
                if math.hypot(x - nearest_x, y - nearest_y) < RADIUS:
                    return False
        return True

    def _range(self, angle: float) -> float:
        heading = math.radians(self.pose.heading + angle)
        step_x, step_y = math.sin(heading), -math.cos(heading)
        distance = 0.0
        while True:
            # Slightly beyond the boundary between two cells, so that the next cell is checked.
            x = self.pose.x + step_x * (distance + 1e-6)
            y = self.pose.y + step_y * (distance + 1e-6)
            column, row = math.floor(x / CELL), math.floor(y / CELL)
            if self._is_block(column, row):
                return distance
            distance += 1e-6 + min(_to_boundary(x, column, step_x), _to_boundary(y, row, step_y))

    def _is_block(self, column: int, row: int) -> bool:
        is_inside = 0 <= row < len(self._plan) and 0 <= column < len(self._plan[row])
        return not is_inside or self._plan[row][column] == "#"


def _to_boundary(position: float, cell: int, step: float) -> float:
    """The distance along a ray to the next cell boundary in one axis."""
    if abs(step) < 1e-9:
        return math.inf
    boundary = (cell + 1) * CELL if step > 0 else cell * CELL
    return max(0.0, (boundary - position) / step)
