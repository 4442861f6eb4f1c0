"""Pairing: a code of 8 letters, typed by hand, in place of a robot's address.

The robot's page shows the code, and its owner says yes or no to the script that asks by it.
"""

from __future__ import annotations

import json
import logging
import random
import re
import time
from typing import Callable, Dict, Optional
from urllib.parse import urlsplit

from .errors import AddressError, NoAnswerError, PairingError
from .problems import error_of, kind_of, may_pass, reason_of
from .requests import Answer, Json, Pause, Request, Talk
from .protocol import USER_AGENT

_pairing_log = logging.getLogger("corridor")

_FIRST_TRY_PAUSE = 0.25
_LONGEST_TRY_PAUSE = 10.0
_ANSWER_POLL = 10.0
_LINE_GRACE = 10.0
#: Beside many wrong codes of the same network, the service checks a code after so long at most.
_LONGEST_CHECK = 10.0
_LETTERS = re.compile(r"[BCDFGHJKLMNPQRSTVWXZ]{8}")
#: Whoever types wrong so often has another problem than a slip of the hand.
_MOST_WRONG_CODES = 10


class _Tries:
    """The wrong codes of this process."""

    wrong = 0


def pair(
    service: str,
    code: str,
    name: Optional[str],
    answer_timeout: float,
    clock: Callable[[], float] = time.monotonic,
    chance: Callable[[], float] = random.random,
) -> Talk[str]:
    """Asks by a code, and waits for the owner's yes. Gives the robot's address."""
    url = f"{_origin_of(service)}/api/v1/pairing"
    if _Tries.wrong >= _MOST_WRONG_CODES:
        raise PairingError(
            "too-many-tries",
            f"{_MOST_WRONG_CODES} wrong codes were typed",
            "Look at the code on the robot's page, and start the script again.",
        )
    letters = re.sub(r"[\s-]", "", code).upper()
    if _LETTERS.fullmatch(letters) is None:
        _Tries.wrong += 1
        raise _wrong_code("It has 8 letters, such as BCDF GHJK, and no vowel.")
    wish = json.dumps({"code": letters, "name": name or None}).encode()
    asking = Request("POST", url, _headers(), wish, _LONGEST_CHECK + _LINE_GRACE)
    asked = yield from _tried(asking, answer_timeout, clock, chance)
    ends = clock() + float(asked["endsInSeconds"])
    _pairing_log.warning("Waiting for 'Yes, let it drive' on the robot's page.")
    waiting = Request(
        "GET",
        f"{url}?wait={_ANSWER_POLL:g}",
        {**_headers(), "Authorization": f"Bearer {asked['key']}"},
        None,
        _ANSWER_POLL + _LINE_GRACE,
    )
    while True:
        said = yield from _tried(waiting, answer_timeout, clock, chance)
        if said["address"] is not None:
            return str(said["address"])
        if clock() >= ends:
            raise PairingError(
                "pairing-over",
                "Nobody has answered",
                "Make a new code in the robot's page, and watch for the question there.",
            )


def _tried(
    request: Request, limit: float, clock: Callable[[], float], chance: Callable[[], float]
) -> Talk[Json]:
    """One request, tried again while the network or the service has a bad moment."""
    began = clock()
    tries = 0
    while True:
        answer = yield request
        if answer is None:
            raise TypeError("whoever runs a talk answers its requests")
        if 200 <= answer.status < 300:
            return _said(answer)
        if not may_pass(answer):
            raise _refusal_of(request, answer)
        pause = chance() * min(_LONGEST_TRY_PAUSE, _FIRST_TRY_PAUSE * 2**tries)
        pause = max(pause, answer.retry_after or 0.0)
        tries += 1
        if clock() - began + pause > limit:
            if answer.status == 429:
                raise _refusal_of(request, answer)
            raise NoAnswerError(
                "timeout",
                f"The service does not answer: {reason_of(answer)}",
                "Check the network, and the address of the page.",
            )
        yield Pause(pause)


def _refusal_of(request: Request, answer: Answer) -> Exception:
    kind, reason = kind_of(answer), reason_of(answer)
    if kind == "pairing-refused":
        return PairingError("pairing-refused", "The robot's owner declined", reason)
    if kind == "too-fast":
        return PairingError("too-many-tries", "Too many codes come from this network", reason)
    if kind == "no-pairing" and request.method == "GET":
        return PairingError("pairing-over", "The pairing code is no longer valid", reason)
    if kind in ("no-pairing", "code-used"):
        _Tries.wrong += 1
        return _wrong_code(reason)
    return error_of(Answer(200)) if kind == "" and answer.status == 404 else error_of(answer)


def _wrong_code(hint: str) -> PairingError:
    return PairingError("wrong-code", "Unknown, expired or used pairing code", hint)


def _headers() -> Dict[str, str]:
    return {
        "Accept": "application/json",
        "Content-Type": "application/json",
        "User-Agent": USER_AGENT,
    }


def _said(answer: Answer) -> Json:
    try:
        said = json.loads(answer.body)
        if "endsInSeconds" in said and ("key" in said or "address" in said):
            return said
    except (ValueError, TypeError):
        pass
    raise error_of(answer)


def _origin_of(service: str) -> str:
    """Where the service is, from the address of its page."""
    parts = urlsplit(service.strip())
    if parts.scheme in ("http", "https") and parts.netloc and "@" not in parts.netloc:
        return f"{parts.scheme}://{parts.netloc}"
    raise AddressError(
        "bad-address",
        "This is not the address of a service",
        "It looks like http://HOST: what the browser shows where the robot's page is open.",
    )
