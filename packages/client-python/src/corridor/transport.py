"""The line itself: HTTPS by the standard library, through the proxy that the machine names."""

from __future__ import annotations

import http.client
import ipaddress
import socket
import ssl
import time
import urllib.error
import urllib.parse
import urllib.request
from typing import Any, Optional

from .requests import Answer, Pause, Request, T, Talk

_LONGEST_ANSWER = 4 * 1024 * 1024


class _NoRedirect(urllib.request.HTTPRedirectHandler):
    """The key goes to the host of the address and to no other."""

    def redirect_request(self, *_arguments: Any, **_named: Any) -> None:
        return None


class Line:
    """Sends requests; holds nothing open between them."""

    def __init__(self) -> None:
        # HTTP_PROXY, HTTPS_PROXY and no_proxy, or what the system's settings say.
        self._through_proxy = urllib.request.build_opener(_NoRedirect)
        self._straight = urllib.request.build_opener(urllib.request.ProxyHandler({}), _NoRedirect)

    def send(self, request: Request) -> Answer:
        """One try. Never raises: a line that is lost is an answer, too."""
        host = urllib.parse.urlsplit(request.url).hostname or ""
        # A proxy would look for a robot of this machine on its own.
        opener = self._straight if _is_here(host) else self._through_proxy
        sent = urllib.request.Request(
            request.url, request.body, dict(request.headers), method=request.method
        )
        try:
            with opener.open(sent, timeout=request.timeout) as answer:
                return _taken_in(answer.status, answer)
        except urllib.error.HTTPError as error:
            with error:
                return _taken_in(error.code, error)
        except urllib.error.URLError as error:
            return _lost(error.reason)
        except (OSError, http.client.HTTPException) as error:
            return _lost(error)


def _taken_in(status: int, answer: Any) -> Answer:
    try:
        body = answer.read(_LONGEST_ANSWER + 1)
    except (OSError, http.client.HTTPException) as error:
        return _lost(error)
    if len(body) > _LONGEST_ANSWER:
        return Answer(0, lost="its answer does not end")
    # Reading up to a limit does not tell by itself that the rest is missing.
    if len(body) < (_number_in(answer.headers.get("Content-Length")) or 0):
        return Answer(0, lost="its answer was cut short")
    return Answer(status, body, _number_in(answer.headers.get("Retry-After")))


def _lost(error: object) -> Answer:
    is_untrusted = isinstance(error, ssl.SSLCertVerificationError)
    # One and the same only since Python 3.10.
    if isinstance(error, (TimeoutError, socket.timeout)):
        return Answer(0, lost="no answer in time")
    return Answer(0, lost=str(error)[:200] or "the line was cut", is_untrusted=is_untrusted)


def _number_in(header: Optional[str]) -> Optional[float]:
    return float(header) if header is not None and header.isdigit() and len(header) < 9 else None


def _is_here(host: str) -> bool:
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def run(talk: Talk[T], line: Line) -> T:
    """Has a talk from its beginning to its end, and waits meanwhile."""
    try:
        step = next(talk)
        while True:
            if isinstance(step, Pause):
                time.sleep(step.seconds)
                step = talk.send(None)
            else:
                step = talk.send(line.send(step))
    except StopIteration as end:
        result: T = end.value
        return result
