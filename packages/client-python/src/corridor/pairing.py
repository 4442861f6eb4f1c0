"""Pairing by a code of 8 letters instead of a robot's address.

The robot's page shows the code, and its owner accepts or refuses the script that uses it.
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
from .problems import error_of, problem_type, is_temporary, reason_of
from .requests import Response, Json, Delay, Request, Exchange
from .protocol import USER_AGENT

_pairing_log = logging.getLogger("corridor")

_FIRST_PAIRING_DELAY = 0.25
_MAX_PAIRING_DELAY = 10.0
_PAIRING_POLL = 10.0
_PAIRING_TIMEOUT = 10.0
#: Seconds by which the service may delay a check after many wrong codes from the same network.
_MAX_CHECK = 10.0
_LETTERS = re.compile(r"[BCDFGHJKLMNPQRSTVWXZ]{8}")
#: Maximum number of wrong codes per process.
_MAX_WRONG_CODES = 10


class _Attempts:
    """The wrong codes of this process."""

    wrong = 0


def pair(
    service: str,
    code: str,
    name: Optional[str],
    answer_timeout: float,
    clock: Callable[[], float] = time.monotonic,
    rand: Callable[[], float] = random.random,
) -> Exchange[str]:
    """Requests access by a code, and waits until the owner accepts. Returns the robot's address."""
    url = f"{_origin_of(service)}/api/v1/pairing"
    if _Attempts.wrong >= _MAX_WRONG_CODES:
        raise PairingError(
            "too-many-tries",
            f"{_MAX_WRONG_CODES} wrong codes were entered",
            "Check the code on the robot's page, and start the script again.",
        )
    letters = re.sub(r"[\s-]", "", code).upper()
    if _LETTERS.fullmatch(letters) is None:
        _Attempts.wrong += 1
        raise _wrong_code("A code has 8 letters, such as BCDF GHJK, and no vowels.")
    body = json.dumps({"code": letters, "name": name or None}).encode()
    request = Request("POST", url, _headers(), body, _MAX_CHECK + _PAIRING_TIMEOUT)
    requested = yield from _with_retries(request, answer_timeout, clock, rand)
    ends = clock() + float(requested["endsInSeconds"])
    _pairing_log.warning("Waiting for 'Yes, let it drive' on the robot's page.")
    poll = Request(
        "GET",
        f"{url}?wait={_PAIRING_POLL:g}",
        {**_headers(), "Authorization": f"Bearer {requested['key']}"},
        None,
        _PAIRING_POLL + _PAIRING_TIMEOUT,
    )
    while True:
        answer = yield from _with_retries(poll, answer_timeout, clock, rand)
        if answer["address"] is not None:
            return str(answer["address"])
        if clock() >= ends:
            raise PairingError(
                "pairing-over",
                "The owner did not answer",
                "Create a new code on the robot's page, and accept this script there.",
            )


def _with_retries(
    request: Request, limit: float, clock: Callable[[], float], rand: Callable[[], float]
) -> Exchange[Json]:
    """Sends a request, and repeats it after temporary failures."""
    start = clock()
    attempts = 0
    while True:
        response = yield request
        if response is None:
            raise TypeError("The runner must send a response to each request")
        if 200 <= response.status < 300:
            return _parse_pairing(response)
        if not is_temporary(response):
            raise _pairing_error(request, response)
        delay = rand() * min(_MAX_PAIRING_DELAY, _FIRST_PAIRING_DELAY * 2**attempts)
        delay = max(delay, response.retry_after or 0.0)
        attempts += 1
        if clock() - start + delay > limit:
            if response.status == 429:
                raise _pairing_error(request, response)
            raise NoAnswerError(
                "timeout",
                f"The service does not respond: {reason_of(response)}",
                "Check the network and the address of the page.",
            )
        yield Delay(delay)


def _pairing_error(request: Request, response: Response) -> Exception:
    kind, reason = problem_type(response), reason_of(response)
    if kind == "pairing-refused":
        return PairingError("pairing-refused", "The robot's owner declined", reason)
    if kind == "too-fast":
        return PairingError("too-many-tries", "Too many codes were sent from this network", reason)
    if kind == "no-pairing" and request.method == "GET":
        return PairingError("pairing-over", "The pairing code is no longer valid", reason)
    if kind in ("no-pairing", "code-used"):
        _Attempts.wrong += 1
        return _wrong_code(reason)
    return error_of(Response(200)) if kind == "" and response.status == 404 else error_of(response)


def _wrong_code(hint: str) -> PairingError:
    return PairingError("wrong-code", "Unknown, expired or used pairing code", hint)


def _headers() -> Dict[str, str]:
    return {
        "Accept": "application/json",
        "Content-Type": "application/json",
        "User-Agent": USER_AGENT,
    }


def _parse_pairing(response: Response) -> Json:
    try:
        body = json.loads(response.body)
        if "endsInSeconds" in body and ("key" in body or "address" in body):
            return body
    except (ValueError, TypeError):
        pass
    raise error_of(response)


def _origin_of(service: str) -> str:
    """The origin of a page's address."""
    parts = urlsplit(service.strip())
    if parts.scheme in ("http", "https") and parts.netloc and "@" not in parts.netloc:
        return f"{parts.scheme}://{parts.netloc}"
    raise AddressError(
        "bad-address",
        "This is not the address of a service",
        "It looks like http://HOST. Copy it from the browser in which the robot's page is open.",
    )
