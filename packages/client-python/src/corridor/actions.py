"""The robot's words as the service takes them, with their numbers checked before they travel."""

from __future__ import annotations

import math
from typing import Any, Dict, Optional

from .errors import CommandError

#: A command as it travels: `{"action": "move", "distance": 100}`.
Action = Dict[str, Any]

_FARTHEST = 25_600
_MOST_DEGREES = 3_600
_LONGEST_DRIVE = 60_000


def plain(action: str) -> Action:
    return {"action": action}


def go_forward(distance: Optional[float]) -> Action:
    return plain("forward") if distance is None else go(distance, "forward")


def go_reverse(distance: Optional[float]) -> Action:
    if distance is None:
        return plain("reverse")
    command = go(distance, "reverse")
    return {**command, "distance": -command["distance"]}


def go(distance: float, word: str) -> Action:
    number = _number(word, "distance", distance, -_FARTHEST, _FARTHEST, "cm")
    return {"action": "move", "distance": number}


def turn_left(degrees: float) -> Action:
    command = turn_by(degrees, "left")
    return plain("left 90") if degrees == 90 else {**command, "degrees": -command["degrees"]}


def turn_right(degrees: float) -> Action:
    command = turn_by(degrees, "right")
    return plain("right 90") if degrees == 90 else command


def turn_by(degrees: float, word: str = "turn") -> Action:
    number = _number(word, "degrees", degrees, -_MOST_DEGREES, _MOST_DEGREES, "degrees")
    return {"action": "turn", "degrees": number}


def power_wheels(left_power: float, right_power: float, milliseconds: Optional[float]) -> Action:
    action: Action = {
        "action": "drive",
        "left": _number("drive", "left", left_power, -1, 1, "(wheel power)"),
        "right": _number("drive", "right", right_power, -1, 1, "(wheel power)"),
    }
    if milliseconds is not None:
        action["milliseconds"] = _number(
            "drive", "milliseconds", milliseconds, 1, _LONGEST_DRIVE, "ms"
        )
    return action


def check_ttl(seconds: Optional[float]) -> Optional[float]:
    """The time to live in seconds, in which a command must have begun."""
    return None if seconds is None else _number("Robot", "ttl", seconds, 0.2, 60, "seconds")


def has_no_end(action: Action) -> bool:
    """Whether the robot goes on with it until something else is chosen."""
    name = action["action"]
    return name in ("forward", "reverse") or (name == "drive" and "milliseconds" not in action)


def _number(word: str, name: str, found: Any, least: float, most: float, unit: str) -> float:
    is_number = isinstance(found, (int, float)) and not isinstance(found, bool)
    if is_number and math.isfinite(found) and least <= found <= most:
        return float(found) if isinstance(found, float) else int(found)
    what = f"{word}() cannot take {found!r:.40} as {name}"
    raise CommandError("bad-command", what, f"Give a number from {least} to {most} {unit}.")
