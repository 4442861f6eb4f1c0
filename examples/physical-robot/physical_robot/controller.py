"""The control loop: executes one command after the other, 50 times per second, and reports."""

from __future__ import annotations

import math
import threading
import time
from typing import Any, Dict, List, Optional, Tuple

from .body import TRACK, SimulatedBody
from .command_requests import Json
from .command_store import CommandStore, Entry
from .conditions import any_true

STEP = 0.02
#: Maximum duration of one call of `drive` in seconds; the motors stop after it.
MAX_STEP = 0.1
#: Speed of a wheel at power 1 and of a straight drive in cm/s, and of a turn in degrees/s.
WHEEL_SPEED = 261.0
SPEED = 100.0
TURN_SPEED = 150.0
#: Seconds after the last request of a script until a motion without an end stops.
SCRIPT_TIMEOUT = 3.0
DRIVE_LEASE = 0.5
#: Seconds between two reports while the robot moves, and while it is stopped.
REPORT_MOVING = 0.05
REPORT_STANDING = 0.5

#: The remainder of a phase: ("move", cm), ("turn", degrees) or ("wheels", seconds).
Phase = Tuple[str, float]
PHASES: Dict[str, List[Phase]] = {
    "left 90": [("turn", -90)],
    "right 90": [("turn", 90)],
    "turn 180": [("turn", 180)],
    "delayed left 90": [("move", 50), ("turn", -90), ("move", 60)],
    "delayed right 90": [("move", 50), ("turn", 90), ("move", 60)],
    "stop": [],
}


class Controller:
    """The control loop. The robot is stopped unless a command is running."""

    def __init__(self, store: CommandStore, body: SimulatedBody, speedup: float = 1.0) -> None:
        """`speedup`: factor by which the simulated body moves faster."""
        self._store = store
        self._body = body
        self._speedup = speedup
        self._entry: Optional[Entry] = None
        self._phases: List[Phase] = []
        self._distance = 0.0
        self._collided = False
        self._started_at = 0.0
        self._up_since = time.monotonic()
        self._reported = 0.0
        self._seq = 0
        self._goal_reached = False
        self.snapshot: Json = {}
        store.progress = self._progress
        self._report()

    def start(self) -> None:
        threading.Thread(target=self._run, name="controller", daemon=True).start()

    def _run(self) -> None:
        before = time.monotonic()
        while True:
            time.sleep(STEP)
            now = time.monotonic()
            with self._store.changed:
                # Limited, so that the robot makes no long step after the machine was suspended.
                self._step(now, min(now - before, MAX_STEP))
            before = now

    def _step(self, now: float, seconds: float) -> None:
        store = self._store
        store.expire()
        # A stop or a replacement may have ended the command since the last step.
        if self._entry is not store.running:
            self._entry = None
        if self._entry is not None and self._is_over(self._entry, now):
            self._entry = None
        if self._entry is None:
            self._start(store.start_next(), now)
        if self._entry is not None:
            self._execute(self._entry, seconds)
        moves = self._entry is not None
        if now - self._reported >= (REPORT_MOVING if moves else REPORT_STANDING):
            self._report()
            store.changed.notify_all()

    def _start(self, entry: Optional[Entry], now: float) -> None:
        self._entry = entry
        self._distance, self._collided, self._started_at = 0.0, False, now
        if entry is None:
            return
        command = entry.request.command
        action = command["action"]
        if action == "move":
            self._phases = [("move", command["distance"])]
        elif action == "turn":
            self._phases = [("turn", command["degrees"])]
        elif action == "drive" and "milliseconds" in command:
            self._phases = [("wheels", command["milliseconds"] / 1_000)]
        else:
            self._phases = list(PHASES.get(action, []))
        if action == "reset":
            self._reset(now)

    def _reset(self, now: float) -> None:
        """Puts the robot at its start, which begins a new run."""
        self._body.reset()
        self._up_since, self._goal_reached = now, False

    def _is_over(self, entry: Entry, now: float) -> bool:
        """Ends a motion without an end if another command waits or its script is disconnected."""
        command = entry.request.command
        if not _has_no_end(command):
            return False
        if "until" in command:
            return self._is_silent(entry, now)
        if self._store.has_waiting:
            self._end(entry, "superseded", "A newer command replaced this command.")
            return True
        is_drive = command["action"] == "drive"
        drive_lease = (entry.request.lease or DRIVE_LEASE * 1_000) / 1_000
        lease = drive_lease if is_drive else SCRIPT_TIMEOUT
        since = self._started_at if is_drive else max(self._started_at, self._store.last_contact)
        is_connected = not is_drive and self._store.open_requests > 0
        if is_connected or now - since < lease:
            return False
        self._end_silent(entry, lease)
        return True

    def _is_silent(self, entry: Entry, now: float) -> bool:
        """Ends a guarded motion if its script is disconnected. The next command waits for its end."""
        last_contact = max(self._started_at, self._store.last_contact)
        if self._store.open_requests > 0 or now - last_contact < SCRIPT_TIMEOUT:
            return False
        self._end_silent(entry, SCRIPT_TIMEOUT)
        return True

    def _end_silent(self, entry: Entry, lease: float) -> None:
        # Programs that the page exports decide again after "stopped sending".
        reason = f"The script stopped sending for {lease:g} s, so the robot stopped."
        self._end(entry, "cancelled", reason)

    def _execute(self, entry: Entry, seconds: float) -> None:
        command = entry.request.command
        if _has_no_end(command):
            # Conditions that are true at the start end the motion before the robot moves.
            if self._is_reached(command):
                return self._end(entry, "completed")
            self._drive(*self._wheels_of(command), seconds)
            if self._body.bumping:
                self._end(entry, "collided")
            if not entry.ended and self._is_reached(command):
                self._end(entry, "completed")
            return
        while self._phases:
            kind, remaining = self._phases[0]
            if not self._advance(kind, remaining, command, seconds):
                return
            self._phases.pop(0)
            if self._phases:
                return
        self._end(entry, "collided" if self._collided else "completed")
        self._entry = None

    def _is_reached(self, command: Json) -> bool:
        """Whether a condition of a guarded motion is true."""
        until = command.get("until")
        return until is not None and any_true(until, self._body.ranges(), self._body.at_goal)

    def _advance(self, kind: str, remaining: float, command: Json, seconds: float) -> bool:
        """Executes one step of a phase. Returns whether the phase is complete."""
        if kind == "wheels":
            step = min(remaining, seconds)
            self._drive(*self._wheels_of(command), step)
            self._phases[0] = (kind, remaining - step)
            return remaining - step <= 1e-9
        max_step = (SPEED if kind == "move" else TURN_SPEED) * self._speedup * seconds
        step = max(-max_step, min(max_step, remaining))
        if kind == "move":
            self._drive(step / seconds, step / seconds, seconds)
        else:
            wheel = step / seconds * TRACK / 2 * math.pi / 180
            self._drive(wheel, -wheel, seconds)
        self._phases[0] = (kind, remaining - step)
        if kind == "move" and self._body.bumping:
            self._collided = True
            return True
        return abs(remaining - step) <= 1e-9

    def _drive(self, left: float, right: float, seconds: float) -> None:
        self._distance += self._body.drive(left, right, seconds)
        self._goal_reached = self._goal_reached or self._body.at_goal

    def _wheels_of(self, command: Json) -> Tuple[float, float]:
        if command["action"] == "drive":
            return command["left"] * WHEEL_SPEED, command["right"] * WHEEL_SPEED
        speed = SPEED if command["action"] == "forward" else -SPEED
        return speed, speed

    def _end(self, entry: Entry, state: str, reason: Optional[str] = None) -> None:
        self._store.end(entry, state, reason)

    def _progress(self) -> Tuple[Json, float]:
        """Pose and distance at the end of a command, after a report with the same readings."""
        self._report()
        return self._pose(), round(self._distance, 2)

    def _report(self) -> None:
        running = self._store.running
        self._seq += 1
        self._reported = time.monotonic()
        self.snapshot = {
            "seq": self._seq,
            "tick": int((self._reported - self._up_since) * 60),
            "state": "running",
            "driver": "remote",
            "sensors": self._body.ranges(),
            "pose": self._pose(),
            "motion": "stop" if running is None else running.request.command["action"],
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
