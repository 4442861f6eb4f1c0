"""Estimates how long the network delayed a message, relative to the fastest message of its script.

The clocks of script and host are not synchronised. Only changes of their offset are used.
"""

from __future__ import annotations

import math
import threading
import time
from collections import OrderedDict
from typing import Callable

#: Maximum drift between two clocks. Drift alone never makes a message count as delayed.
MAX_DRIFT = 0.0002
MAX_CLOCKS = 64


class ScriptClock:
    """The monotonic clock of a script, with which it timestamps its messages."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        #: the smallest offset between the host's clock and the script's clock, in ms
        self._offset = math.inf

    def transit(self, sent_at: float) -> float:
        """The delay in ms of a message that arrives now, relative to the fastest message so far."""
        offset = self._clock() * 1_000 * (1 - MAX_DRIFT) - sent_at
        self._offset = min(self._offset, offset)
        return offset - self._offset


class ScriptClocks:
    """Clocks of scripts that send single requests, by the id in their `Script-Clock` header."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._clocks: "OrderedDict[str, ScriptClock]" = OrderedDict()

    def transit(self, clock_id: str, sent_at: float) -> float:
        with self._lock:
            clock = self._clocks.setdefault(clock_id, ScriptClock())
            self._clocks.move_to_end(clock_id)
            if len(self._clocks) > MAX_CLOCKS:
                self._clocks.popitem(last=False)
            return clock.transit(sent_at)
