"""The times that go with a command, so that the robot never starts it late on a slow network."""

from __future__ import annotations

import math
import uuid
from typing import Callable, Dict, Optional

#: The robot's host takes no larger age.
_LARGEST_AGE = 3_600_000


class CommandTimes:
    """The clock of one script, and what it has measured with it.

    Each request says when it was sent, so that the host sees how much longer it took than the
    quickest one. How long the quickest one took the host cannot see; it was at most the smallest
    round trip, so that is added to the age of each command. A command may be thought older than it
    is, by the way back, and never younger.
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self.begin_anew()

    def begin_anew(self) -> None:
        """Another clock for the host, which forgets what it has measured: this one may have stood still."""
        self._id = uuid.uuid4().hex
        self._zero = self._clock()
        self._smallest: Optional[float] = None

    @property
    def is_measured(self) -> bool:
        """Whether a request was answered since the clock began."""
        return self._smallest is not None

    def answered(self, seconds: float) -> None:
        """A request that waits for nothing was answered by the host after so long."""
        if self._smallest is None or seconds < self._smallest:
            self._smallest = seconds

    def header(self) -> Dict[str, str]:
        """When the request is sent, for the host."""
        return {"Script-Clock": f"{self._id} {math.floor((self._clock() - self._zero) * 1_000)}"}

    def age(self, began: float) -> int:
        """ms since the first try of a command, and what it may take on its way at most."""
        seconds = self._clock() - began + (self._smallest or 0.0)
        return min(_LARGEST_AGE, math.ceil(round(seconds * 1_000, 3)))
