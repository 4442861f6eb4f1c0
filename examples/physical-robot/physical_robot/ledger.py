"""Every command from its acceptance to its one ending, and what readers are told of it.

One lock guards it; whoever waits for something waits on its condition. It is kept in memory: a host
that is started again begins anew, with a stream of another name and no command.
"""

from __future__ import annotations

import secrets
import threading
import time
from collections import deque
from dataclasses import dataclass
from datetime import datetime, timezone
from typing import Callable, Deque, Dict, List, Optional, Tuple

from .orders import Json, Order
from .problems import Problem

ENDINGS = ("completed", "collided", "cancelled", "superseded", "expired")
MOST_WAITING = 64
TAKEN_BACK = "Its script cancelled it. Send it again if the robot should still do it."
KEPT_EVENTS = 1_000
LOG_PAGE = 200


@dataclass
class Entry:
    seq: int
    key: Optional[str]
    order: Order
    accepted_at: str
    #: by the host's monotonic clock, which nobody sets
    deadline: float
    state: str = "accepted"
    reason: Optional[str] = None
    pose: Optional[Json] = None
    distance: Optional[float] = None

    @property
    def ended(self) -> bool:
        return self.state in ENDINGS

    def record(self, duplicate: bool = False) -> Json:
        return {
            "seq": self.seq,
            "key": self.key,
            "action": self.order.command["action"],
            "command": self.order.command,
            "state": self.state,
            "reason": self.reason,
            "acceptedAt": self.accepted_at,
            "pose": self.pose,
            "distance": self.distance,
            "duplicate": duplicate,
        }


class Ledger:
    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self.changed = threading.Condition()
        self.running: Optional[Entry] = None
        #: where the robot is, and how far it has come with the command that runs; the pilot knows
        self.way_so_far: Callable[[], Tuple[Json, float]] = lambda: ({}, 0.0)
        #: when a script was heard last
        self.heard_at = clock()
        #: requests of scripts that wait for their answer
        self.listeners = 0
        self.stream = secrets.token_hex(4)
        self._clock = clock
        self._entries: List[Entry] = []
        self._by_key: Dict[str, Entry] = {}
        self._waiting: Deque[Entry] = deque()
        self._events: Deque[Tuple[int, Json]] = deque(maxlen=KEPT_EVENTS)
        self.newest_event = 0

    # --- scripts; the caller holds the lock ---

    def submit(self, order: Order, key: Optional[str]) -> Json:
        """Takes a command in, or gives the record of the one that came with this key before."""
        before = None if key is None else self._by_key.get(key)
        if before is not None:
            if before.order.command == order.command:
                return before.record(duplicate=True)
            detail = f"This key belongs to command {before.seq}. Use a new key for each command."
            raise Problem(409, "key-conflict", detail)
        if order.age >= order.ttl:
            detail = (
                f"This command was to start within {order.ttl:g} ms and is {order.age:g} ms old. "
                "Look where the robot is now, then send what fits as a new command."
            )
            raise Problem(422, "too-late", detail)
        is_stop = order.command["action"] == "stop"
        if len(self._waiting) >= MOST_WAITING and not is_stop and not order.replace:
            detail = f"{MOST_WAITING} commands wait at this robot. Wait until one has ended."
            raise Problem(429, "queue-full", detail, headers={"Retry-After": "1"})
        deadline = self._clock() + (order.ttl - order.age) / 1_000
        entry = Entry(len(self._entries) + 1, key, order, _now(), deadline)
        self._entries.append(entry)
        if key is not None:
            self._by_key[key] = entry
        if is_stop:
            self._end_all("cancelled", f"stopped by command {entry.seq}")
        elif order.replace:
            self._end_all("superseded", f"replaced by command {entry.seq}")
        self._waiting.append(entry)
        self.changed.notify_all()
        return entry.record()

    def cancel(self, seq: int) -> Json:
        """Takes one command back."""
        entry = self.entry(seq)
        if not entry.ended:
            self.end(entry, "cancelled", TAKEN_BACK)
        return entry.record()

    def entry(self, seq: int) -> Entry:
        if 1 <= seq <= len(self._entries):
            return self._entries[seq - 1]
        detail = f"This robot has no command {seq}. GET .../commands lists those that it has."
        raise Problem(404, "no-command", detail)

    def log(self, after: int) -> List[Json]:
        return [entry.record() for entry in self._entries[after : after + LOG_PAGE]]

    def events_after(self, n: int) -> Tuple[Optional[Json], List[Tuple[int, Json]]]:
        """What was told after an event; with a gap in the place of what is forgotten."""
        oldest = self._events[0][0] if self._events else self.newest_event + 1
        if n > self.newest_event or n < oldest - 1:
            return self.gap(), []
        return None, [(number, record) for number, record in self._events if number > n]

    def gap(self) -> Json:
        open_ones = [entry for entry in [self.running, *self._waiting] if entry is not None]
        states = [{"seq": entry.seq, "state": entry.state} for entry in open_ones]
        return {"n": self.newest_event, "open": states}

    # --- the robot; the caller holds the lock ---

    def begin_next(self) -> Optional[Entry]:
        """The next command, which begins now; what came too late ends first."""
        self.expire()
        if not self._waiting:
            return None
        self.running = self._waiting.popleft()
        self.running.state = "started"
        self._tell(self.running)
        return self.running

    @property
    def has_waiting(self) -> bool:
        return len(self._waiting) > 0

    def expire(self) -> None:
        """Ends what waits too long behind another one."""
        now = self._clock()
        for entry in [entry for entry in self._waiting if entry.deadline <= now]:
            self.end(entry, "expired", "it could not begin in time")

    def end(self, entry: Entry, state: str, reason: Optional[str] = None) -> None:
        """The one and only ending of a command."""
        pose: Optional[Json] = None
        distance: Optional[float] = None
        if self.running is entry:
            # First, so that the snapshot of the ending no longer names the command.
            self.running = None
            pose, distance = self.way_so_far()
        elif entry in self._waiting:
            self._waiting.remove(entry)
        entry.state, entry.reason, entry.pose, entry.distance = state, reason, pose, distance
        self._tell(entry)

    def _end_all(self, state: str, reason: str) -> None:
        for entry in [self.running, *self._waiting]:
            if entry is not None:
                self.end(entry, state, reason)

    def _tell(self, entry: Entry) -> None:
        self.newest_event += 1
        self._events.append((self.newest_event, entry.record()))
        self.changed.notify_all()


def _now() -> str:
    return datetime.now(timezone.utc).isoformat(timespec="milliseconds").replace("+00:00", "Z")
