"""Commands that scripts send, validated field by field."""

from __future__ import annotations

import json
import math
from typing import Any, Dict, List, Optional, Tuple

from .conditions import EXPECTED, are_valid
from .problems import Problem, bad_request

SIMPLE_ACTIONS = (
    "forward",
    "reverse",
    "stop",
    "left 90",
    "right 90",
    "turn 180",
    "delayed left 90",
    "delayed right 90",
)
ACTIONS = (*SIMPLE_ACTIONS, "move", "turn", "drive", "reset")
Range = Tuple[float, float, str]
#: Required numbers of each action: minimum, maximum, description.
REQUIRED_FIELDS: Dict[str, Dict[str, Range]] = {
    "move": {"distance": (-25_600, 25_600, "a distance in cm")},
    "turn": {"degrees": (-3_600, 3_600, "an angle in degrees")},
    "drive": {"left": (-1, 1, "a wheel power"), "right": (-1, 1, "a wheel power")},
}
#: Optional numbers.
OPTIONAL_FIELDS: Dict[str, Range] = {
    "ttl": (200, 60_000, "a time to live in milliseconds"),
    "age": (0, 3_600_000, "an age in milliseconds"),
}
OPTIONAL_DRIVE_FIELDS: Dict[str, Range] = {
    "milliseconds": (1, 60_000, "a time in milliseconds"),
    "lease": (100, 2_000, "a lease in milliseconds"),
}
#: Actions that conditions can end, unless they have another end.
GUARDED_ACTIONS = ("forward", "reverse", "drive")
DEFAULT_TTL = 10_000

Json = Dict[str, Any]


class CommandRequest:
    """A validated command and its options: time to live, age, replace, lease."""

    def __init__(self, fields: Json) -> None:
        option_names = ("ttl", "age", "replace", "lease")
        self.command: Json = {name: fields[name] for name in fields if name not in option_names}
        self.ttl: float = fields.get("ttl", DEFAULT_TTL)
        self.age: float = fields.get("age", 0)
        self.replace: bool = fields.get("replace", False)
        self.lease: Optional[float] = fields.get("lease")


def read_json(body: bytes) -> Json:
    """Parses the JSON object in a request's body."""
    try:
        fields = json.loads(body.decode("utf-8"), parse_constant=_reject_constant)
    except (ValueError, RecursionError) as error:
        raise _invalid([_error("", str(error)[:60], "a JSON document")]) from None
    if not isinstance(fields, dict):
        raise _invalid([_error("", _format(fields), "an object of JSON")])
    return fields


def parse_command(fields: Any) -> CommandRequest:
    """Validates a command. Raises a Problem that lists each invalid field."""
    if not isinstance(fields, dict):
        raise _invalid([_error("", _format(fields), "a command such as {\"action\": \"left 90\"}")])
    action = fields.get("action")
    if action not in ACTIONS:
        raise _invalid([_error("action", _format(action), f"one of {', '.join(ACTIONS)}")])
    required = REQUIRED_FIELDS.get(action, {})
    drive_fields = OPTIONAL_DRIVE_FIELDS if action == "drive" else {}
    allowed = {**required, **OPTIONAL_FIELDS, **drive_fields}
    errors = [
        _error(name, _format(fields.get(name)), f"{what} from {minimum} to {maximum}")
        for name, (minimum, maximum, what) in allowed.items()
        if name in required or name in fields
        if not is_within(fields.get(name), minimum, maximum)
    ]
    if not isinstance(fields.get("replace", False), bool):
        errors.append(_error("replace", _format(fields["replace"]), "true or false"))
    if "until" in fields:
        errors.extend(_until_errors(fields))
    for name in fields:
        if name not in allowed and name not in ("action", "replace", "until"):
            errors.append(_error(name[:60], _format(fields[name]), "no field of this name"))
    if errors:
        raise _invalid(errors[:20])
    return CommandRequest(fields)


def _until_errors(fields: Json) -> List[Dict[str, str]]:
    has_end = "milliseconds" in fields or "lease" in fields
    if fields["action"] not in GUARDED_ACTIONS or has_end:
        expected = "until only with forward, reverse, or drive without milliseconds and lease"
    elif are_valid(fields["until"]):
        return []
    else:
        expected = EXPECTED
    return [_error("until", _format(fields["until"]), expected)]


def is_within(value: Any, minimum: float, maximum: float) -> bool:
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return is_number and math.isfinite(value) and minimum <= value <= maximum


def _reject_constant(name: str) -> None:
    raise ValueError(f"{name} is not a JSON number")


def _format(value: Any) -> str:
    return "nothing" if value is None else repr(value)[:60]


def _error(path: str, found: str, expected: str) -> Dict[str, str]:
    return {"path": path, "found": found, "expected": expected}


def _invalid(errors: List[Dict[str, str]]) -> Problem:
    return bad_request("Invalid command.", errors)
