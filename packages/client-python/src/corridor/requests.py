"""Requests and responses, independent of the transport.

An Exchange is a generator that yields each Request or Delay and receives the Response. Its runner
decides how to wait, so that the same exchanges serve scripts with and without asyncio.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Generator, Mapping, Optional, TypeVar, Union


@dataclass(frozen=True)
class Request:
    method: str
    url: str
    headers: Mapping[str, str]
    body: Optional[bytes]
    #: seconds until the request is given up
    timeout: float


@dataclass(frozen=True)
class Delay:
    seconds: float


@dataclass(frozen=True)
class Response:
    """A response. `status` 0: there is none, and `error` has the reason."""

    status: int
    body: bytes = b""
    retry_after: Optional[float] = None
    error: str = ""
    #: whether the server's certificate is not trusted
    is_untrusted: bool = False


T = TypeVar("T")
Exchange = Generator[Union[Request, Delay], Optional[Response], T]
#: A parsed JSON body.
Json = Any
