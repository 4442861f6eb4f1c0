"""Conditions that end a guarded motion: validation and evaluation."""

from __future__ import annotations

import math
from typing import Any, Callable, Dict, List

MAX_CONDITIONS = 200
MAX_NUMBER = 100_000
SENSORS = ("front", "right", "back", "left")
COMPARE: Dict[str, Callable[[float, float], bool]] = {
    ">": lambda reading, limit: reading > limit,
    "<": lambda reading, limit: reading < limit,
    ">=": lambda reading, limit: reading >= limit,
    "<=": lambda reading, limit: reading <= limit,
}
EXPECTED = (
    f"1 to {MAX_CONDITIONS} conditions, such as "
    '{"sensor": "front", "is": "<=", "than": 60} or {"goal": true}'
)

Condition = Dict[str, Any]


def are_valid(conditions: Any) -> bool:
    """Whether this is a list of conditions."""
    is_list = isinstance(conditions, list) and 1 <= len(conditions) <= MAX_CONDITIONS
    return is_list and all(_is_valid(condition) for condition in conditions)


def any_true(conditions: List[Condition], readings: Dict[str, float], at_goal: bool) -> bool:
    """Whether one of the conditions is true now."""
    return any(_is_true(condition, readings, at_goal) for condition in conditions)


def _is_true(condition: Condition, readings: Dict[str, float], at_goal: bool) -> bool:
    if "goal" in condition:
        return at_goal
    than = condition["than"]
    limit = readings["right"] + condition["plus"] if than == "right" else than
    return COMPARE[condition["is"]](readings[condition["sensor"]], limit)


def _is_valid(condition: Any) -> bool:
    if not isinstance(condition, dict):
        return False
    if "goal" in condition:
        return condition["goal"] is True and len(condition) == 1
    if condition.get("is") not in COMPARE or condition.get("sensor") not in SENSORS:
        return False
    if condition.get("than") != "right":
        return len(condition) == 3 and _is_number(condition.get("than"), 0)
    is_left = condition["sensor"] == "left" and len(condition) == 4
    return is_left and _is_number(condition.get("plus"), -MAX_NUMBER)


def _is_number(value: Any, minimum: float) -> bool:
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return is_number and math.isfinite(value) and minimum <= value <= MAX_NUMBER
