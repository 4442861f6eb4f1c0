"""Turns error responses into exceptions with a hint."""

from __future__ import annotations

import json
from typing import Any, Optional

from .address import Address
from .errors import (
    AddressError,
    CommandEndedError,
    CommandError,
    NoMazeError,
    NotAuthorisedError,
    RobotError,
    RobotGoneError,
)
from .requests import Response

#: Statuses of temporary failures.
_TEMPORARY = (0, 408, 425, 429)
#: Prefix of the relay's keys that permit only reading.
_WATCH_KEY = "wch_"


def as_sentence(text: str) -> str:
    """Capitalises and punctuates a reason."""
    text = text[:1].upper() + text[1:]
    return text if text.endswith((".", "!", "?")) else text + "."


def is_temporary(response: Response) -> bool:
    return not response.is_untrusted and (response.status in _TEMPORARY or response.status >= 500)


def reason_of(response: Response) -> str:
    """The problem's detail and its field errors, without repetition."""
    if response.status == 0:
        return response.error
    try:
        problem: Any = json.loads(response.body)
        detail = str(problem["detail"])
        fields = [
            f"{error['path'] or 'document'}: found {error['found']}, expected {error['expected']}."
            for error in problem["errors"]
        ]
        # The relay's `detail` contains the first field, with other quotation marks.
        rest = [field for field in fields if field.replace('"', "'") not in detail]
        return " ".join([detail, *rest])[:1_000]
    except (ValueError, KeyError, TypeError):
        return f"The response has the status {response.status} and no reason."


def error_of(response: Response, address: Optional[Address] = None) -> RobotError:
    """The exception for a permanent failure of a request to a robot."""
    if response.is_untrusted:
        return AddressError(
            "bad-address",
            f"The certificate of this address is not trusted here: {response.error}",
            "If the network has its own certificate, set SSL_CERT_FILE to its file.",
        )
    reason = reason_of(response)
    status, kind = response.status, problem_type(response)
    if 200 <= status < 400:
        return AddressError(
            "bad-address",
            "The response does not come from a robot's host",
            "Copy the whole address again. If the network has a sign-in page, sign in first.",
        )
    if kind == "blocked":
        return NotAuthorisedError("blocked", "This script is blocked", reason)
    if kind == "forbidden" and address is not None and address.key.startswith(_WATCH_KEY):
        return NotAuthorisedError(
            "not-authorised",
            "This is a watch link: it can only read",
            "Copy the robot's address: press 'Copy address with key' under Remote on the robot's page.",
        )
    if kind == "reset-disabled":
        return CommandError("refused", "Scripts may not reset this robot", reason)
    if status in (401, 403):
        return NotAuthorisedError("not-authorised", "The robot rejects this key", reason)
    if status == 407:
        return RobotError("refused", "The network's proxy requires a user name and a password", reason)
    if kind == "no-snapshot":
        return RobotGoneError("robot-gone", "The robot has not reported yet", reason)
    if kind == "no-maze":
        return NoMazeError("no-maze", "The maze of this robot is unknown", reason)
    if kind == "too-late":
        return CommandEndedError("expired", "The command arrived too late and was not executed", reason)
    if kind == "no-robot" and address is not None:
        return RobotGoneError("no-robot", f"No robot has the id {address.id}", reason)
    if status in (404, 410) and kind != "no-command":
        return RobotGoneError("no-robot", "There is no robot with this address", reason)
    return CommandError("refused", "The robot's host refused the request", reason)


def problem_type(response: Response) -> str:
    """The last part of a problem's type; empty if there is none."""
    try:
        return str(json.loads(response.body)["type"]).rsplit("/", 1)[-1]
    except (ValueError, KeyError, TypeError):
        return ""
