"""How much longer than the quickest message of its script another one was on its way.

The clocks of script and host are never compared: only how the difference between them changes.
"""

from __future__ import annotations

import math
import threading
import time
from collections import OrderedDict
from typing import Callable

#: Two clocks may drift apart by so much. A message is never thought late for drift alone.
LARGEST_DRIFT = 0.0002
MOST_CLOCKS = 64


class ScriptClock:
    """One monotonic clock of a script, by which it times what it sends."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        #: the smallest difference between the host's clock and the script's, in ms
        self._offset = math.inf

    def transit(self, sent_at: float) -> float:
        """ms by which a message that arrives now was slower than the quickest one before."""
        offset = self._clock() * 1_000 * (1 - LARGEST_DRIFT) - sent_at
        self._offset = min(self._offset, offset)
        return offset - self._offset


class ScriptClocks:
    """The clocks of scripts that send single requests, by the ids in their `Script-Clock` headers."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._clocks: "OrderedDict[str, ScriptClock]" = OrderedDict()

    def transit(self, clock_id: str, sent_at: float) -> float:
        with self._lock:
            clock = self._clocks.setdefault(clock_id, ScriptClock())
            self._clocks.move_to_end(clock_id)
            if len(self._clocks) > MOST_CLOCKS:
                self._clocks.popitem(last=False)
            return clock.transit(sent_at)
