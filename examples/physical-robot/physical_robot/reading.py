"""What stands in an address or a header, checked."""

from __future__ import annotations

import re
from typing import Dict

from .problems import Problem, bad_request

LONGEST_WAIT = 25.0
_WAIT = re.compile(r"\d{1,2}(\.\d{1,3})?")
_NUMBER = re.compile(r"\d{1,15}")


def number_in(text: str, name: str) -> int:
    if _NUMBER.fullmatch(text) is None:
        raise wrong(name, text, "a whole number of at most 15 digits")
    return int(text)


def wait_in(query: Dict[str, str]) -> float:
    """`?wait=S`, in seconds."""
    text = query.get("wait", "0")
    if _WAIT.fullmatch(text) is None or float(text) > LONGEST_WAIT:
        raise wrong("wait", text, f"seconds to wait, from 0 to {LONGEST_WAIT:g}")
    return float(text)


def wrong(path: str, found: str, expected: str) -> Problem:
    error = {"path": path, "found": found[:60], "expected": expected}
    return bad_request("The request is wrong.", [error])


def nothing_here() -> Problem:
    return Problem(404, "not-found", "Check the address. The API begins with /api/v1/robots/ID.")


def not_known(method: str, allowed: str) -> Problem:
    detail = f"{method} is not known here. This address knows: {allowed}."
    return Problem(405, "method-not-allowed", detail, headers={"Allow": allowed})
