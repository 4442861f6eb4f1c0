"""Creates and validates the commands of the service."""

from __future__ import annotations

import math
from typing import Any, Dict, Optional

from .errors import CommandError

#: The JSON of a command: `{"action": "move", "distance": 100}`.
Action = Dict[str, Any]

_MAX_DISTANCE = 25_600
_MAX_DEGREES = 3_600
_MAX_DRIVE_MS = 60_000


def plain(action: str) -> Action:
    return {"action": action}


def go_forward(distance: Optional[float]) -> Action:
    return plain("forward") if distance is None else go(distance, "forward")


def go_reverse(distance: Optional[float]) -> Action:
    if distance is None:
        return plain("reverse")
    command = go(distance, "reverse")
    return {**command, "distance": -command["distance"]}


def go(distance: float, method: str) -> Action:
    number = _number(method, "distance", distance, -_MAX_DISTANCE, _MAX_DISTANCE, "cm")
    return {"action": "move", "distance": number}


def turn_left(degrees: float) -> Action:
    command = turn_by(degrees, "left")
    return plain("left 90") if degrees == 90 else {**command, "degrees": -command["degrees"]}


def turn_right(degrees: float) -> Action:
    command = turn_by(degrees, "right")
    return plain("right 90") if degrees == 90 else command


def turn_by(degrees: float, method: str = "turn") -> Action:
    number = _number(method, "degrees", degrees, -_MAX_DEGREES, _MAX_DEGREES, "degrees")
    return {"action": "turn", "degrees": number}


def power_wheels(left_power: float, right_power: float, milliseconds: Optional[float]) -> Action:
    action: Action = {
        "action": "drive",
        "left": _number("drive", "left", left_power, -1, 1, "(wheel power)"),
        "right": _number("drive", "right", right_power, -1, 1, "(wheel power)"),
    }
    if milliseconds is not None:
        action["milliseconds"] = _number(
            "drive", "milliseconds", milliseconds, 1, _MAX_DRIVE_MS, "ms"
        )
    return action


def check_ttl(seconds: Optional[float]) -> Optional[float]:
    """Validates a time to live in seconds."""
    return None if seconds is None else _number("Robot", "ttl", seconds, 0.2, 60, "seconds")


def is_endless(action: Action) -> bool:
    """Whether the motion continues until the next command."""
    name = action["action"]
    return name in ("forward", "reverse") or (name == "drive" and "milliseconds" not in action)


def _number(method: str, name: str, found: Any, minimum: float, maximum: float, unit: str) -> float:
    is_number = isinstance(found, (int, float)) and not isinstance(found, bool)
    if is_number and math.isfinite(found) and minimum <= found <= maximum:
        return float(found) if isinstance(found, float) else int(found)
    what = f"{method}() does not accept {found!r:.40} as {name}"
    raise CommandError("bad-command", what, f"Pass a number from {minimum} to {maximum} {unit}.")
