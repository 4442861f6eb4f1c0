"""The robot's body: two wheels, four range finders, a bumper. Here it is simulated.

This is the one module to replace for a physical robot: `drive` sets the motors, `ranges` reads the
range finders, `pose` is what wheel encoders and a gyroscope make of the way so far.

`drive` is called 50 times a second while the robot moves, and not at all while it stands or after
this program has crashed. So motors must stop by themselves when no call has come for 0.1 s: let the
motor controller do this. The simulated wheels turn only within a call.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Dict, List

#: One character of the room's plan is so many cm wide.
CELL = 100.0
RADIUS = 25.0
TRACK = 40.0
#: Headings of the range finders, seen from the front, in degrees clockwise.
FINDERS = {"front": 0, "right": 90, "back": 180, "left": 270}


@dataclass
class Pose:
    """cm to the right and down from the room's corner, degrees clockwise from north."""

    x: float
    y: float
    heading: float


class SimulatedBody:
    """A body in a room of blocks. It stops where it touches a wall."""

    def __init__(self, plan: List[str]) -> None:
        """`plan`: rows of `#` for a block, `.` for floor, `G` for a goal and `S` for the start.

        It starts at `S`, else on the first floor, and faces north.
        """
        self._plan = plan
        start = "S" if any("S" in cells for cells in plan) else "."
        row = next(index for index, cells in enumerate(plan) if start in cells)
        self.pose = Pose((plan[row].index(start) + 0.5) * CELL, (row + 0.5) * CELL, 0.0)
        self.bumping = False
        self.bumps = 0

    def drive(self, left: float, right: float, seconds: float) -> float:
        """Turns the wheels, in cm/s each, for so many seconds: 0.1 at most. Motors stop 0.1 s after the
        last call.

        Returns how many cm the robot drove, never below 0.
        """
        turned = math.degrees((left - right) / TRACK * seconds)
        way = (left + right) / 2 * seconds
        middle = math.radians(self.pose.heading + turned / 2)
        self.pose.heading = (self.pose.heading + turned) % 360
        share = self._free_share(way, middle)
        self.pose.x += math.sin(middle) * way * share
        self.pose.y -= math.cos(middle) * way * share
        touches = share < 1
        if touches and not self.bumping:
            self.bumps += 1
        self.bumping = touches
        return abs(way) * share

    @property
    def has_goal(self) -> bool:
        """Whether there is a goal in the room that its floor sensor can see."""
        return any("G" in cells for cells in self._plan)

    @property
    def at_goal(self) -> bool:
        column, row = math.floor(self.pose.x / CELL), math.floor(self.pose.y / CELL)
        return not self._is_block(column, row) and self._plan[row][column] == "G"

    def ranges(self) -> Dict[str, float]:
        """cm from the robot's centre to the next wall, in four directions."""
        return {name: round(self._range(angle), 2) for name, angle in FINDERS.items()}

    def _free_share(self, way: float, heading: float) -> float:
        """How much of a way there is room for, from 0 to 1."""
        free, taken = 0.0, 1.0
        if self._has_room(way, heading):
            return 1.0
        for _ in range(12):
            share = (free + taken) / 2
            free, taken = (share, taken) if self._has_room(way * share, heading) else (free, share)
        return free

    def _has_room(self, way: float, heading: float) -> bool:
        x = self.pose.x + math.sin(heading) * way
        y = self.pose.y - math.cos(heading) * way
        for row in range(int((y - RADIUS) // CELL), int((y + RADIUS) // CELL) + 1):
            for column in range(int((x - RADIUS) // CELL), int((x + RADIUS) // CELL) + 1):
                if not self._is_block(column, row):
                    continue
                near_x = min(max(x, column * CELL), (column + 1) * CELL)
                near_y = min(max(y, row * CELL), (row + 1) * CELL)
                if math.hypot(x - near_x, y - near_y) < RADIUS:
                    return False
        return True

    def _range(self, angle: float) -> float:
        heading = math.radians(self.pose.heading + angle)
        step_x, step_y = math.sin(heading), -math.cos(heading)
        far = 0.0
        while True:
            # A hair beyond the line between two cells, so that the next cell is looked at.
            x, y = self.pose.x + step_x * (far + 1e-6), self.pose.y + step_y * (far + 1e-6)
            column, row = math.floor(x / CELL), math.floor(y / CELL)
            if self._is_block(column, row):
                return far
            far += 1e-6 + min(_to_line(x, column, step_x), _to_line(y, row, step_y))

    def _is_block(self, column: int, row: int) -> bool:
        is_inside = 0 <= row < len(self._plan) and 0 <= column < len(self._plan[row])
        return not is_inside or self._plan[row][column] == "#"


def _to_line(place: float, cell: int, step: float) -> float:
    """How far it is to the next line between cells in one direction."""
    if abs(step) < 1e-9:
        return math.inf
    line = (cell + 1) * CELL if step > 0 else cell * CELL
    return max(0.0, (line - place) / step)
