"""What goes over the line and comes back, without the line: the talk is written on these.

A talk is a generator. It yields a Request or a Pause and is given the Answer; whoever runs it
decides how to wait, so that one talk serves scripts with and without asyncio.
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
    #: seconds until the line counts as lost
    timeout: float


@dataclass(frozen=True)
class Pause:
    seconds: float


@dataclass(frozen=True)
class Answer:
    """What came back. `status` 0: nothing did, and `lost` says why."""

    status: int
    body: bytes = b""
    retry_after: Optional[float] = None
    lost: str = ""
    #: the other side could not prove who it is
    is_untrusted: bool = False


T = TypeVar("T")
Talk = Generator[Union[Request, Pause], Optional[Answer], T]
#: The answer of one call, as JSON says it.
Json = Any
