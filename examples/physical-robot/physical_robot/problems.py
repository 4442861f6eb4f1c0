"""Errors of the host as problem documents (RFC 9457)."""

from __future__ import annotations

from typing import Any, Dict, List, Optional

_TITLES = {
    "bad-request": "Invalid request",
    "not-authorised": "Missing or invalid key",
    "not-found": "Not found",
    "no-robot": "Robot not found",
    "no-command": "Command not found",
    "no-maze": "Maze not found",
    "method-not-allowed": "Method not allowed",
    "key-conflict": "The idempotency key was used for another command",
    "too-large": "The body is too large",
    "not-json": "The body is not JSON",
    "too-late": "The command arrived too late",
    "not-supported": "The robot cannot do this",
    "queue-full": "Too many waiting commands",
    "too-fast": "Too many requests",
    "internal": "Internal server error",
}


class Problem(Exception):
    """An error response. `detail` describes the error and how to fix it."""

    def __init__(
        self,
        status: int,
        kind: str,
        detail: str,
        errors: Optional[List[Dict[str, str]]] = None,
        headers: Optional[Dict[str, str]] = None,
    ) -> None:
        super().__init__(detail)
        self.status = status
        self.headers = headers or {}
        self.document: Dict[str, Any] = {
            "type": f"/problems/{kind}",
            "title": _TITLES[kind],
            "status": status,
            "detail": detail,
            "errors": errors or [],
        }


def bad_request(what: str, errors: List[Dict[str, str]]) -> Problem:
    """Invalid input. `detail` contains the first invalid field, for scripts that show only it."""
    first = errors[0]
    named = f"{first['path'] or 'document'}: found {first['found']}, expected {first['expected']}."
    more = " The field 'errors' lists all problems." if len(errors) > 1 else ""
    return Problem(400, "bad-request", f"{what} {named}{more}".replace('"', "'"), errors)
