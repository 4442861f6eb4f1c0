"""What a script may ask for, checked field by field before anything moves."""

from __future__ import annotations

import json
import math
from typing import Any, Dict, List, Optional, Tuple

from .problems import Problem, bad_request

PLAIN = (
    "forward",
    "reverse",
    "stop",
    "left 90",
    "right 90",
    "turn 180",
    "delayed left 90",
    "delayed right 90",
)
NAMES = (*PLAIN, "move", "turn", "drive")
Range = Tuple[float, float, str]
#: The numbers of each action: least, most, what it is.
NUMBERS: Dict[str, Dict[str, Range]] = {
    "move": {"distance": (-25_600, 25_600, "a distance in cm")},
    "turn": {"degrees": (-3_600, 3_600, "an angle in degrees")},
    "drive": {"left": (-1, 1, "a wheel power"), "right": (-1, 1, "a wheel power")},
}
#: Numbers that may be left out.
TERMS: Dict[str, Range] = {
    "ttl": (200, 60_000, "a time to live in milliseconds"),
    "age": (0, 3_600_000, "an age in milliseconds"),
}
DRIVE_TERMS: Dict[str, Range] = {
    "milliseconds": (1, 60_000, "a time in milliseconds"),
    "lease": (100, 2_000, "a lease in milliseconds"),
}
DEFAULT_TTL = 10_000

Json = Dict[str, Any]


class Order:
    """A command, and beside it how long the wish holds."""

    def __init__(self, fields: Json) -> None:
        beside = ("ttl", "age", "replace", "lease")
        self.command: Json = {name: fields[name] for name in fields if name not in beside}
        self.ttl: float = fields.get("ttl", DEFAULT_TTL)
        self.age: float = fields.get("age", 0)
        self.replace: bool = fields.get("replace", False)
        self.lease: Optional[float] = fields.get("lease")


def read_json(body: bytes) -> Json:
    """The object in a request's body."""
    try:
        fields = json.loads(body.decode("utf-8"), parse_constant=_no_number)
    except (ValueError, RecursionError) as error:
        raise _wrong([_error("", str(error)[:60], "a JSON document")]) from None
    if not isinstance(fields, dict):
        raise _wrong([_error("", _show(fields), "an object of JSON")])
    return fields


def order_of(fields: Any) -> Order:
    """What a script asks for. Raises Problem that names each wrong field."""
    if not isinstance(fields, dict):
        raise _wrong([_error("", _show(fields), "a command such as {\"action\": \"left 90\"}")])
    action = fields.get("action")
    if action not in NAMES:
        raise _wrong([_error("action", _show(action), f"one of {', '.join(NAMES)}")])
    needed = NUMBERS.get(action, {})
    allowed = {**needed, **TERMS, **(DRIVE_TERMS if action == "drive" else {})}
    errors = [
        _error(name, _show(fields.get(name)), f"{what} from {least} to {most}")
        for name, (least, most, what) in allowed.items()
        if (name in needed or name in fields) and not is_within(fields.get(name), least, most)
    ]
    if not isinstance(fields.get("replace", False), bool):
        errors.append(_error("replace", _show(fields["replace"]), "true or false"))
    for name in fields:
        if name not in allowed and name not in ("action", "replace"):
            errors.append(_error(name[:60], _show(fields[name]), "no field of this name"))
    if errors:
        raise _wrong(errors[:20])
    return Order(fields)


def is_within(value: Any, least: float, most: float) -> bool:
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return is_number and math.isfinite(value) and least <= value <= most


def _no_number(name: str) -> None:
    raise ValueError(f"{name} is no number of JSON")


def _show(value: Any) -> str:
    return "nothing" if value is None else repr(value)[:60]


def _error(path: str, found: str, expected: str) -> Dict[str, str]:
    return {"path": path, "found": found, "expected": expected}


def _wrong(errors: List[Dict[str, str]]) -> Problem:
    return bad_request("The command is wrong.", errors)
