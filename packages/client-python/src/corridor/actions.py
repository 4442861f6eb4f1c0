"""Creates and validates the commands of the service."""

from __future__ import annotations

import math
from typing import Any, Dict, Optional, Sequence, Union

from .errors import CommandError

#: The JSON of a command: `{"action": "move", "distance": 100}`.
Action = Dict[str, Any]
#: A condition that ends a motion: `{"sensor": "front", "is": "<=", "than": 60}`, `{"sensor": "left",
#: "is": ">", "than": "right", "plus": 1}`, or `{"goal": True}`.
Condition = Dict[str, Any]
#: One condition, or up to 200.
Until = Union[Condition, Sequence[Condition]]

_MAX_DISTANCE = 25_600
_MAX_DEGREES = 3_600
_MAX_DRIVE_MS = 60_000
_MAX_CONDITIONS = 200


def plain(action: str) -> Action:
    return {"action": action}


def go_forward(distance: Optional[float], until: Optional[Until] = None) -> Action:
    if distance is None:
        return guarded(plain("forward"), until)
    _check_alone(until, "forward", "a distance")
    return go(distance, "forward")


def go_reverse(distance: Optional[float], until: Optional[Until] = None) -> Action:
    if distance is None:
        return guarded(plain("reverse"), until)
    _check_alone(until, "reverse", "a distance")
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


def power_wheels(
    left_power: float,
    right_power: float,
    milliseconds: Optional[float],
    until: Optional[Until] = None,
) -> Action:
    action: Action = {
        "action": "drive",
        "left": _number("drive", "left", left_power, -1, 1, "(wheel power)"),
        "right": _number("drive", "right", right_power, -1, 1, "(wheel power)"),
    }
    if milliseconds is None:
        action = guarded(action, until)
    else:
        _check_alone(until, "drive", "milliseconds")
        action["milliseconds"] = _number(
            "drive", "milliseconds", milliseconds, 1, _MAX_DRIVE_MS, "ms"
        )
    return action


def guarded(action: Action, until: Optional[Until]) -> Action:
    """Adds the conditions that end a motion. The service validates their fields."""
    if until is None:
        return action
    conditions = [until] if isinstance(until, dict) else until
    is_list = isinstance(conditions, (list, tuple)) and 1 <= len(conditions) <= _MAX_CONDITIONS
    if is_list and all(isinstance(condition, dict) for condition in conditions):
        return {**action, "until": list(conditions)}
    what = f"{action['action']}() does not accept {until!r:.40} as until"
    hint = 'Pass a condition, such as {"sensor": "front", "is": "<=", "than": 60}, or a list of them.'
    raise CommandError("bad-command", what, hint)


def _check_alone(until: Optional[Until], method: str, other: str) -> None:
    if until is not None:
        what = f"{method}() does not accept {other} together with until"
        raise CommandError("bad-command", what, "Pass one of the two.")


def check_ttl(seconds: Optional[float]) -> Optional[float]:
    """Validates a time to live in seconds."""
    return None if seconds is None else _number("Robot", "ttl", seconds, 0.2, 60, "seconds")


def is_endless(action: Action) -> bool:
    """Whether the motion continues until the next command."""
    if "until" in action:
        return False
    name = action["action"]
    return name in ("forward", "reverse") or (name == "drive" and "milliseconds" not in action)


def _number(method: str, name: str, found: Any, minimum: float, maximum: float, unit: str) -> float:
    is_number = isinstance(found, (int, float)) and not isinstance(found, bool)
    if is_number and math.isfinite(found) and minimum <= found <= maximum:
        return float(found) if isinstance(found, float) else int(found)
    what = f"{method}() does not accept {found!r:.40} as {name}"
    raise CommandError("bad-command", what, f"Pass a number from {minimum} to {maximum} {unit}.")
