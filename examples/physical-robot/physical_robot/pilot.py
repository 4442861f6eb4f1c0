"""Does one command after the other with the body, fifty times a second, and reports."""

from __future__ import annotations

import math
import threading
import time
from typing import Any, Dict, List, Optional, Tuple

from .body import TRACK, SimulatedBody
from .ledger import Entry, Ledger
from .orders import Json

STEP = 0.02
#: One call of `drive` is for so many seconds at most; motors stop by themselves after them.
LONGEST_STEP = 0.1
#: cm/s of a wheel at power 1, of a drive straight on, degrees/s of a turn on the spot
WHEEL_SPEED = 261.0
SPEED = 100.0
TURN_SPEED = 150.0
#: A motion without an end goes on for so many seconds after its script was heard last.
SILENCE = 3.0
DRIVE_LEASE = 0.5
#: Seconds between two reports while it moves, and while it stands.
REPORT_MOVING = 0.05
REPORT_STANDING = 0.5

#: What is left of a command: ("move", cm), ("turn", degrees) or ("wheels", seconds).
Part = Tuple[str, float]
PARTS: Dict[str, List[Part]] = {
    "left 90": [("turn", -90)],
    "right 90": [("turn", 90)],
    "turn 180": [("turn", 180)],
    "delayed left 90": [("move", 50), ("turn", -90), ("move", 60)],
    "delayed right 90": [("move", 50), ("turn", 90), ("move", 60)],
    "stop": [],
}


class Pilot:
    """The control loop. The robot stands unless a command says otherwise."""

    def __init__(self, ledger: Ledger, body: SimulatedBody, haste: float = 1.0) -> None:
        """`haste`: how many times faster than usual the simulated body moves."""
        self._ledger = ledger
        self._body = body
        self._haste = haste
        self._entry: Optional[Entry] = None
        self._parts: List[Part] = []
        self._distance = 0.0
        self._collided = False
        self._began = 0.0
        self._up_since = time.monotonic()
        self._reported = 0.0
        self._seq = 0
        self._goal_reached = False
        self.snapshot: Json = {}
        ledger.way_so_far = self._way_so_far
        self._report()

    def start(self) -> None:
        threading.Thread(target=self._fly, name="pilot", daemon=True).start()

    def _fly(self) -> None:
        before = time.monotonic()
        while True:
            time.sleep(STEP)
            now = time.monotonic()
            with self._ledger.changed:
                # A machine that slept must not make up for it with one long step.
                self._step(now, min(now - before, LONGEST_STEP))
            before = now

    def _step(self, now: float, seconds: float) -> None:
        ledger = self._ledger
        ledger.expire()
        # Whoever sent a stop or a replacement has ended it meanwhile.
        if self._entry is not ledger.running:
            self._entry = None
        if self._entry is not None and self._is_over(self._entry, now):
            self._entry = None
        if self._entry is None:
            self._begin(ledger.begin_next(), now)
        if self._entry is not None:
            self._work(self._entry, seconds)
        moves = self._entry is not None
        if now - self._reported >= (REPORT_MOVING if moves else REPORT_STANDING):
            self._report()
            ledger.changed.notify_all()

    def _begin(self, entry: Optional[Entry], now: float) -> None:
        self._entry = entry
        self._distance, self._collided, self._began = 0.0, False, now
        if entry is None:
            return
        command = entry.order.command
        action = command["action"]
        if action == "move":
            self._parts = [("move", command["distance"])]
        elif action == "turn":
            self._parts = [("turn", command["degrees"])]
        elif action == "drive" and "milliseconds" in command:
            self._parts = [("wheels", command["milliseconds"] / 1_000)]
        else:
            self._parts = list(PARTS.get(action, []))

    def _is_over(self, entry: Entry, now: float) -> bool:
        """Ends a motion without an end, when another one waits or its script is silent."""
        command = entry.order.command
        if not _has_no_end(command):
            return False
        if self._ledger.has_waiting:
            self._end(entry, "superseded", "another command came")
            return True
        is_drive = command["action"] == "drive"
        lease = (entry.order.lease or DRIVE_LEASE * 1_000) / 1_000 if is_drive else SILENCE
        since = self._began if is_drive else max(self._began, self._ledger.heard_at)
        is_heard = not is_drive and self._ledger.listeners > 0
        if is_heard or now - since < lease:
            return False
        self._end(entry, "cancelled", f"nothing was heard of its script for {lease:g} s")
        return True

    def _work(self, entry: Entry, seconds: float) -> None:
        command = entry.order.command
        if _has_no_end(command):
            self._drive(*self._wheels_of(command), seconds)
            if self._body.bumping:
                self._end(entry, "collided")
            return
        while self._parts:
            kind, rest = self._parts[0]
            if not self._do(kind, rest, command, seconds):
                return
            self._parts.pop(0)
            if self._parts:
                return
        self._end(entry, "collided" if self._collided else "completed")
        self._entry = None

    def _do(self, kind: str, rest: float, command: Json, seconds: float) -> bool:
        """One step of a part, no further than its end. Gives whether it is over."""
        if kind == "wheels":
            step = min(rest, seconds)
            self._drive(*self._wheels_of(command), step)
            self._parts[0] = (kind, rest - step)
            return rest - step <= 1e-9
        most = (SPEED if kind == "move" else TURN_SPEED) * self._haste * seconds
        step = max(-most, min(most, rest))
        if kind == "move":
            self._drive(step / seconds, step / seconds, seconds)
        else:
            wheel = step / seconds * TRACK / 2 * math.pi / 180
            self._drive(wheel, -wheel, seconds)
        self._parts[0] = (kind, rest - step)
        if kind == "move" and self._body.bumping:
            self._collided = True
            return True
        return abs(rest - step) <= 1e-9

    def _drive(self, left: float, right: float, seconds: float) -> None:
        self._distance += self._body.drive(left, right, seconds)
        self._goal_reached = self._goal_reached or self._body.at_goal

    def _wheels_of(self, command: Json) -> Tuple[float, float]:
        if command["action"] == "drive":
            return command["left"] * WHEEL_SPEED, command["right"] * WHEEL_SPEED
        speed = SPEED if command["action"] == "forward" else -SPEED
        return speed, speed

    def _end(self, entry: Entry, state: str, reason: Optional[str] = None) -> None:
        self._ledger.end(entry, state, reason)

    def _way_so_far(self) -> Tuple[Json, float]:
        """Asked for when a command ends: who hears of it and reads the sensors sees them as they were."""
        self._report()
        return self._pose(), round(self._distance, 2)

    def _report(self) -> None:
        running = self._ledger.running
        self._seq += 1
        self._reported = time.monotonic()
        self.snapshot = {
            "seq": self._seq,
            "tick": int((self._reported - self._up_since) * 60),
            "state": "running",
            "driver": "remote",
            "sensors": self._body.ranges(),
            "pose": self._pose(),
            "motion": "stop" if running is None else running.order.command["action"],
            "bumps": self._body.bumps,
            "bumping": self._body.bumping,
            "goalReached": self._goal_reached,
            "line": None,
            "command": None if running is None else running.seq,
        }

    def _pose(self) -> Dict[str, Any]:
        pose = self._body.pose
        heading = round(pose.heading, 2) % 360
        return {"x": round(pose.x, 2), "y": round(pose.y, 2), "heading": heading}


def _has_no_end(command: Json) -> bool:
    action = command["action"]
    return action in ("forward", "reverse") or (
        action == "drive" and "milliseconds" not in command
    )
