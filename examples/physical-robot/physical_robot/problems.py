"""What the host refuses, as problem documents (RFC 9457)."""

from __future__ import annotations

from typing import Any, Dict, List, Optional

_TITLES = {
    "bad-request": "The request cannot be read",
    "not-authorised": "A valid key is missing",
    "not-found": "There is nothing here",
    "no-robot": "There is no such robot",
    "no-command": "There is no such command",
    "method-not-allowed": "This address does not know the method",
    "key-conflict": "The idempotency key was used for another command",
    "too-large": "The body is too large",
    "not-json": "The body is not JSON",
    "too-late": "The command came too late",
    "queue-full": "Too many commands wait",
    "internal": "The robot's host made a mistake",
}


class Problem(Exception):
    """A refusal on its way to whoever asked. `detail` says what happened and how to mend it."""

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
    """Input of the wrong form. The first wrong field stands in `detail`, where short scripts look."""
    first = errors[0]
    named = f"{first['path'] or 'document'}: found {first['found']}, expected {first['expected']}."
    rest = " The field 'errors' lists all that is wrong." if len(errors) > 1 else ""
    return Problem(400, "bad-request", f"{what} {named}{rest}".replace('"', "'"), errors)
