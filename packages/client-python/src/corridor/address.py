"""The address of a robot, `https://HOST/r/ID#KEY`: everything that a script needs."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Optional
from urllib.parse import urlsplit

from .errors import AddressError

_MAX_ADDRESS = 400
_ADDRESS = re.compile(r"(https?://[^/?#\s@]+)/r/([A-Za-z0-9_-]{1,64})(?:#([A-Za-z0-9_-]{8,64}))?")
_KEY = re.compile(r"[A-Za-z0-9_-]{8,64}")
_COPY = "copy the whole address from the page, under Remote"


@dataclass(frozen=True)
class Address:
    """A parsed address. Its `repr` does not contain the key."""

    origin: str
    id: str
    key: str = field(repr=False)

    @property
    def api(self) -> str:
        """Base URL of the robot's API."""
        return f"{self.origin}/api/v1/robots/{self.id}"

    @property
    def whole(self) -> str:
        """The complete address with its key."""
        return f"{self.origin}/r/{self.id}#{self.key}"


def parse_address(text: str, key: Optional[str] = None) -> Address:
    """Parses a robot's address; `key` replaces the key in it.

    Raises AddressError with a hint for common mistakes. The error does not repeat the text, because it
    contains the key.
    """
    if not isinstance(text, str):
        raise _wrong(f"An address is a text in quotes: {_COPY}.")
    text = text.strip()
    match = _ADDRESS.fullmatch(text) if len(text) <= _MAX_ADDRESS else None
    if match is None:
        raise _wrong(_hint_for(text[:_MAX_ADDRESS]))
    origin, robot_id, own_key = match.groups()
    if not _has_host(origin):
        raise _wrong(f"The name or number between http:// and /r/ is wrong: {_COPY}.")
    if key is not None:
        own_key = key.strip().lstrip("#")
    if own_key is None or _KEY.fullmatch(own_key) is None:
        raise _wrong(f'The key after the # is missing or incomplete: {_COPY}, and put it in "quotes".')
    return Address(origin, robot_id, own_key)


def _has_host(origin: str) -> bool:
    """Whether the host can be in a request; "robots..example" cannot."""
    try:
        parts = urlsplit(origin)
        (parts.hostname or "").encode("idna")
        return parts.hostname is not None and parts.port != 0
    except ValueError:
        return False


def _wrong(hint: str) -> AddressError:
    return AddressError("bad-address", "This is not a robot's address", hint)


def _hint_for(text: str) -> str:
    if text == "":
        return f"It is empty: {_COPY}."
    if not re.match(r"https?://", text):
        return f"An address begins with http:// or https://: {_COPY}."
    if re.match(r"https?://[^/]*@", text):
        return f"It contains a user name before the @: {_COPY}."
    if re.fullmatch(r"https?://[^/]+/r/[^#]+#?", text):
        return f'The key after the # is missing: {_COPY}, and put it in "quotes" on a command line.'
    if re.match(r"https?://HOST\b", text):
        return f"HOST, ID and KEY stand for your robot's address: {_COPY}."
    return f"An address looks like http://HOST/r/ID#KEY: {_COPY}."
