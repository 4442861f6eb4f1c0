"""HTTP by the standard library, through the proxy of the environment or the system."""

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

from .requests import Response, Delay, Request, T, Exchange

_MAX_RESPONSE = 4 * 1024 * 1024


class _NoRedirect(urllib.request.HTTPRedirectHandler):
    """Follows no redirects, so that the key is sent only to the host of the address."""

    def redirect_request(self, *_arguments: Any, **_named: Any) -> None:
        return None


class HttpTransport:
    """Sends requests, each with its own connection."""

    def __init__(self) -> None:
        # HTTP_PROXY, HTTPS_PROXY and no_proxy, or the system's settings.
        self._proxied = urllib.request.build_opener(_NoRedirect)
        self._direct = urllib.request.build_opener(urllib.request.ProxyHandler({}), _NoRedirect)

    def send(self, request: Request) -> Response:
        """Sends a request once. Never raises: a failed connection is a response with status 0."""
        try:
            host = urllib.parse.urlsplit(request.url).hostname or ""
            # A proxy would resolve a local address to itself.
            opener = self._direct if _is_local(host) else self._proxied
            sent = urllib.request.Request(
                request.url, request.body, dict(request.headers), method=request.method
            )
            with opener.open(sent, timeout=request.timeout) as response:
                return _read_response(response.status, response)
        except urllib.error.HTTPError as error:
            with error:
                return _read_response(error.code, error)
        except urllib.error.URLError as error:
            return _failure(error.reason)
        except (OSError, ValueError, http.client.HTTPException) as error:
            # ValueError: a host or header that cannot be sent.
            return _failure(error)


def _read_response(status: int, response: Any) -> Response:
    try:
        body = response.read(_MAX_RESPONSE + 1)
    except (OSError, http.client.HTTPException) as error:
        return _failure(error)
    if len(body) > _MAX_RESPONSE:
        return Response(0, error="the response is too long")
    # read() does not raise if the body is shorter than Content-Length.
    if len(body) < (_number_in(response.headers.get("Content-Length")) or 0):
        return Response(0, error="the response is incomplete")
    return Response(status, body, _number_in(response.headers.get("Retry-After")))


def _failure(error: object) -> Response:
    is_untrusted = isinstance(error, ssl.SSLCertVerificationError)
    # They are the same class only since Python 3.10.
    if isinstance(error, (TimeoutError, socket.timeout)):
        return Response(0, error="no response in time")
    return Response(0, error=str(error)[:200] or "connection lost", is_untrusted=is_untrusted)


def _number_in(header: Optional[str]) -> Optional[float]:
    return float(header) if header is not None and header.isdigit() and len(header) < 9 else None


def _is_local(host: str) -> bool:
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def run(exchange: Exchange[T], transport: HttpTransport) -> T:
    """Runs an exchange to its end."""
    try:
        step = next(exchange)
        while True:
            if isinstance(step, Delay):
                time.sleep(step.seconds)
                step = exchange.send(None)
            else:
                step = exchange.send(transport.send(step))
    except StopIteration as end:
        result: T = end.value
        return result
