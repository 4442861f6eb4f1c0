"""From an answer that is no success to an error that a reader can act on."""

from __future__ import annotations

import json
from typing import Any

from .errors import (
    AddressError,
    CommandEndedError,
    CommandError,
    NoMazeError,
    NotAuthorisedError,
    RobotError,
    RobotGoneError,
)
from .requests import Answer

#: The other side had a bad moment: the same request may pass the next time.
_PASSING = (0, 408, 425, 429)


def sentence(text: str) -> str:
    """Some hosts say their reasons as a phrase."""
    text = text[:1].upper() + text[1:]
    return text if text.endswith((".", "!", "?")) else text + "."


def may_pass(answer: Answer) -> bool:
    return not answer.is_untrusted and (answer.status in _PASSING or answer.status >= 500)


def reason_of(answer: Answer) -> str:
    """What the service says is wrong, each field once."""
    if answer.status == 0:
        return answer.lost
    try:
        problem: Any = json.loads(answer.body)
        detail = str(problem["detail"])
        fields = [
            f"{error['path'] or 'document'}: found {error['found']}, expected {error['expected']}."
            for error in problem["errors"]
        ]
        # The relay puts the first field into `detail`, with other quotation marks.
        rest = [field for field in fields if field.replace('"', "'") not in detail]
        return " ".join([detail, *rest])[:1_000]
    except (ValueError, KeyError, TypeError):
        return f"It answered with status {answer.status} and gave no reason."


def error_of(answer: Answer) -> RobotError:
    """The error behind a refusal that no retry mends."""
    if answer.is_untrusted:
        return AddressError(
            "bad-address",
            f"The certificate of this address is not trusted here: {answer.lost}",
            "Where the network has a certificate of its own, set SSL_CERT_FILE to its file.",
        )
    reason = reason_of(answer)
    status, kind = answer.status, kind_of(answer)
    if 200 <= status < 400:
        return AddressError(
            "bad-address",
            "Something else than a robot's host answers at this address",
            "Copy the whole address again; a network with a sign-in page wants that done first.",
        )
    if kind == "blocked":
        return NotAuthorisedError("blocked", "This script is blocked", reason)
    if status in (401, 403):
        return NotAuthorisedError("not-authorised", "The robot does not take this key", reason)
    if status == 407:
        return RobotError("refused", "The network's proxy wants a name and a password", reason)
    if kind == "no-snapshot":
        return RobotGoneError("robot-gone", "The robot has not reported yet", reason)
    if kind == "no-maze":
        return NoMazeError("no-maze", "The maze of this robot is not known", reason)
    if kind == "too-late":
        return CommandEndedError("expired", "The command came too late, so the robot did not do it", reason)
    if status in (404, 410) and kind != "no-command":
        return RobotGoneError("no-robot", "There is no robot with this address", reason)
    return CommandError("refused", "The robot's host did not take this", reason)


def kind_of(answer: Answer) -> str:
    """The last part of a problem's type; nothing where there is none."""
    try:
        return str(json.loads(answer.body)["type"]).rsplit("/", 1)[-1]
    except (ValueError, KeyError, TypeError):
        return ""
