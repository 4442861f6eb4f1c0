"""Validates values in URLs and headers."""

from __future__ import annotations

import re
from typing import Dict

from .problems import Problem, bad_request

MAX_WAIT = 25.0
_WAIT = re.compile(r"\d{1,2}(\.\d{1,3})?")
_NUMBER = re.compile(r"\d{1,15}")


def parse_number(text: str, name: str) -> int:
    if _NUMBER.fullmatch(text) is None:
        raise invalid(name, text, "a whole number of at most 15 digits")
    return int(text)


def parse_wait(query: Dict[str, str]) -> float:
    """Parses `?wait=S` in seconds."""
    text = query.get("wait", "0")
    if _WAIT.fullmatch(text) is None or float(text) > MAX_WAIT:
        raise invalid("wait", text, f"seconds to wait, from 0 to {MAX_WAIT:g}")
    return float(text)


def invalid(path: str, found: str, expected: str) -> Problem:
    error = {"path": path, "found": found[:60], "expected": expected}
    return bad_request("Invalid request.", [error])


def not_found() -> Problem:
    return Problem(404, "not-found", "Check the path for typing errors. API paths start with /api/v1/robots/ID.")


def method_not_allowed(method: str, allowed: str) -> Problem:
    detail = f"{method} is not allowed. Allowed methods: {allowed}."
    return Problem(405, "method-not-allowed", detail, headers={"Allow": allowed})
