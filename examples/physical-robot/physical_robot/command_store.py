"""Stores all commands with their states, and the events about state changes.

One lock guards the store; threads wait on its condition. The store is in memory: a restarted host
has no commands, and its event stream has another name.
"""

from __future__ import annotations

import secrets
import threading
import time
from collections import deque
from dataclasses import dataclass
from datetime import datetime, timezone
from typing import Callable, Deque, Dict, List, Optional, Tuple

from .command_requests import CommandRequest, Json
from .problems import Problem

ENDINGS = ("completed", "collided", "cancelled", "superseded", "expired")
MAX_WAITING = 64
MAX_EVENTS = 1_000
CANCELLED_BY_SCRIPT = "The script cancelled this command. To run it, send a new command."
LOG_PAGE = 200
#: Least seconds between two resets.
RESET_INTERVAL = 1.0


@dataclass
class Entry:
    seq: int
    key: Optional[str]
    request: CommandRequest
    accepted_at: str
    #: in seconds of the host's monotonic clock
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
            "action": self.request.command["action"],
            "command": self.request.command,
            "state": self.state,
            "reason": self.reason,
            "acceptedAt": self.accepted_at,
            "pose": self.pose,
            "distance": self.distance,
            "duplicate": duplicate,
        }


class CommandStore:
    def __init__(
        self, clock: Callable[[], float] = time.monotonic, can_reset: bool = False
    ) -> None:
        """`can_reset`: whether the body can put itself at its start."""
        self.changed = threading.Condition()
        self.running: Optional[Entry] = None
        #: returns the pose, and the distance of the running command; set by the controller
        self.progress: Callable[[], Tuple[Json, float]] = lambda: ({}, 0.0)
        #: time of the last request of a script
        self.last_contact = clock()
        #: number of long-poll requests that are waiting
        self.open_requests = 0
        self.stream = secrets.token_hex(4)
        self._clock = clock
        self._can_reset = can_reset
        self._next_reset = 0.0
        self._entries: List[Entry] = []
        self._by_key: Dict[str, Entry] = {}
        self._waiting: Deque[Entry] = deque()
        self._events: Deque[Tuple[int, Json]] = deque(maxlen=MAX_EVENTS)
        self.newest_event = 0

    # --- for requests of scripts; the caller holds the lock ---

    def submit(self, request: CommandRequest, key: Optional[str]) -> Json:
        """Accepts a command. Returns the record of the earlier command if its key is the same."""
        before = None if key is None else self._by_key.get(key)
        if before is not None:
            if before.request.command == request.command:
                return before.record(duplicate=True)
            detail = (
                f"Command {before.seq} already uses this idempotency key. "
                "Use a new key for each command."
            )
            raise Problem(409, "key-conflict", detail)
        if request.age >= request.ttl:
            detail = (
                f"The command is {request.age:g} ms old, and its time to live (ttl) is {request.ttl:g} ms. "
                "Check where the robot is now, then send a new command, with a longer ttl if possible."
            )
            raise Problem(422, "too-late", detail)
        is_stop = request.command["action"] == "stop"
        is_reset = request.command["action"] == "reset"
        if is_reset:
            self._check_reset()
        replaces = request.replace or is_reset
        if len(self._waiting) >= MAX_WAITING and not is_stop and not replaces:
            detail = (
                f"{MAX_WAITING} commands wait at this robot, the maximum. "
                "Wait until one ends, then send this command again."
            )
            raise Problem(429, "queue-full", detail, headers={"Retry-After": "1"})
        deadline = self._clock() + (request.ttl - request.age) / 1_000
        entry = Entry(len(self._entries) + 1, key, request, _now(), deadline)
        self._entries.append(entry)
        if key is not None:
            self._by_key[key] = entry
        if is_stop:
            self._end_all("cancelled", f"Command {entry.seq} stopped this command.")
        elif replaces:
            self._end_all("superseded", f"Command {entry.seq} replaced this command.")
        self._waiting.append(entry)
        self.changed.notify_all()
        return entry.record()

    def _check_reset(self) -> None:
        if not self._can_reset:
            detail = (
                "This robot cannot put itself at its start. Carry it there, or continue from "
                "where it is."
            )
            raise Problem(422, "not-supported", detail)
        now = self._clock()
        if now < self._next_reset:
            detail = "A robot accepts one reset a second. Wait a second, then send this command again."
            raise Problem(429, "too-fast", detail, headers={"Retry-After": "1"})
        self._next_reset = now + RESET_INTERVAL

    def cancel(self, seq: int) -> Json:
        """Cancels a command unless it has ended."""
        entry = self.entry(seq)
        if not entry.ended:
            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)
        return entry.record()

    def entry(self, seq: int) -> Entry:
        if 1 <= seq <= len(self._entries):
            return self._entries[seq - 1]
        detail = f"This robot has no command {seq}. List its commands with GET .../commands."
        raise Problem(404, "no-command", detail)

    def log(self, after: int) -> List[Json]:
        return [entry.record() for entry in self._entries[after : after + LOG_PAGE]]

    def events_after(self, n: int) -> Tuple[Optional[Json], List[Tuple[int, Json]]]:
        """Events after number `n`, or a gap if some of these events are no longer stored."""
        oldest = self._events[0][0] if self._events else self.newest_event + 1
        if n > self.newest_event or n < oldest - 1:
            return self.gap(), []
        return None, [(number, record) for number, record in self._events if number > n]

    def gap(self) -> Json:
        open_entries = [entry for entry in [self.running, *self._waiting] if entry is not None]
        states = [{"seq": entry.seq, "state": entry.state} for entry in open_entries]
        return {"n": self.newest_event, "open": states}

    # --- for the controller; the caller holds the lock ---

    def start_next(self) -> Optional[Entry]:
        """Starts and returns the next command, after expired commands have ended."""
        self.expire()
        # Of waiting velocities only the newest counts.
        while len(self._waiting) > 1 and all(map(_is_velocity, list(self._waiting)[:2])):
            self.end(self._waiting[0], "superseded", "a newer velocity came")
        if not self._waiting:
            return None
        self.running = self._waiting.popleft()
        self.running.state = "started"
        self._publish(self.running)
        return self.running

    @property
    def has_waiting(self) -> bool:
        return len(self._waiting) > 0

    def expire(self) -> None:
        """Ends waiting commands whose time to live has passed."""
        now = self._clock()
        for entry in [entry for entry in self._waiting if entry.deadline <= now]:
            reason = f"Not started within {entry.request.ttl / 1_000:g} s: earlier commands took longer."
            self.end(entry, "expired", reason)

    def end(self, entry: Entry, state: str, reason: Optional[str] = None) -> None:
        """Ends a command. The caller ensures that it has not ended before."""
        pose: Optional[Json] = None
        distance: Optional[float] = None
        if self.running is entry:
            # Reset first, so that the snapshot of the ending no longer contains the command.
            self.running = None
            pose, distance = self.progress()
        elif entry in self._waiting:
            self._waiting.remove(entry)
        entry.state, entry.reason, entry.pose, entry.distance = state, reason, pose, distance
        self._publish(entry)

    def _end_all(self, state: str, reason: str) -> None:
        for entry in [self.running, *self._waiting]:
            if entry is not None:
                self.end(entry, state, reason)

    def _publish(self, entry: Entry) -> None:
        self.newest_event += 1
        self._events.append((self.newest_event, entry.record()))
        self.changed.notify_all()


def _is_velocity(entry: Entry) -> bool:
    command = entry.request.command
    has_end = "milliseconds" in command or "until" in command
    return command["action"] == "drive" and not has_end


def _now() -> str:
    return datetime.now(timezone.utc).isoformat(timespec="milliseconds").replace("+00:00", "Z")
