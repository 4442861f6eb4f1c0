"""Send times and ages of commands, so that the robot never starts a command late."""

from __future__ import annotations

import math
import uuid
from typing import Callable, Dict, Optional

#: The largest age that the robot's host accepts, in ms.
_MAX_AGE = 3_600_000


class CommandTimes:
    """The clock of one script, and its measurements.

    Each request contains its send time. By this the host computes how much longer the request took
    than the fastest one. The fastest one took at most the shortest round trip, which this class adds
    to the age of each command. The age may be too high, by up to the time of the response, and never
    too low.
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self.reset()

    def reset(self) -> None:
        """Starts a new clock without measurements: the old one may have stopped during sleep."""
        self._id = uuid.uuid4().hex
        self._start = self._clock()
        self._shortest_round_trip: Optional[float] = None

    @property
    def is_measured(self) -> bool:
        """Whether a request was answered since the clock started."""
        return self._shortest_round_trip is not None

    def answered(self, seconds: float) -> None:
        """Records the round trip of a request without a long poll."""
        if self._shortest_round_trip is None or seconds < self._shortest_round_trip:
            self._shortest_round_trip = seconds

    def header(self) -> Dict[str, str]:
        """The header with the send time of a request."""
        return {"Script-Clock": f"{self._id} {math.floor((self._clock() - self._start) * 1_000)}"}

    def age(self, first_sent_at: float) -> int:
        """ms since the first attempt of a command, plus the maximum transit time."""
        seconds = self._clock() - first_sent_at + (self._shortest_round_trip or 0.0)
        return min(_MAX_AGE, math.ceil(round(seconds * 1_000, 3)))
