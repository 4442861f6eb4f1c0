"""The messages of a WebSocket by plain HTTPS, for libraries that speak in messages.

A script posts its messages and fetches those of the host by long poll. Each side numbers what it
sends, 1, 2, 3, so that a request that failed can be made again.
"""

from __future__ import annotations

import hmac
import secrets
import time
from typing import Callable, Dict, List, Optional, Tuple

from .clocks import ScriptClock
from .ledger import Ledger
from .orders import Json, is_within, order_of, read_json
from .pilot import Pilot
from .problems import Problem
from .reading import not_known, nothing_here, number_in, wrong

VERSION = 1
MOST_MESSAGES = 64
MOST_LINES = 16
#: the latest time of a script's clock, in ms
LATEST = 999_999_999_999_999
#: A line on which nothing comes for so many seconds is forgotten.
SILENCE = 15.0
#: Snapshots come at most so often, in seconds.
PACE = 0.1

Wait = Callable[[Callable[[], bool]], None]


class _Line:
    def __init__(self, n: int) -> None:
        self.key = "lin_" + secrets.token_urlsafe(16)
        self.heard_at = time.monotonic()
        #: number of the last message that the script has sent
        self.taken = 0
        #: not known to have come, and the number of the first of them
        self.outbox: List[Json] = []
        self.first = 1
        #: the last event and the last snapshot that were told
        self.n = n
        self.seq = -1
        self.told_at = 0.0
        self.clock = ScriptClock()

    def transit(self, message: Json) -> float:
        """ms that a message was on its way longer than the quickest one; 0 where it has no time."""
        sent_at = message.get("sentAt")
        if sent_at is None:
            return 0.0
        if not is_within(sent_at, 0, LATEST):
            raise wrong("sentAt", str(sent_at), f"milliseconds from 0 to {LATEST}")
        return self.clock.transit(sent_at)


class Lines:
    """All lines that are open. The ledger's lock guards them."""

    def __init__(self, ledger: Ledger, pilot: Pilot, key: str) -> None:
        self._ledger = ledger
        self._pilot = pilot
        self._key = key
        self._lines: List[_Line] = []

    def call(
        self, method: str, path: str, key: str, query: Dict[str, str], body: bytes, wait: Wait
    ) -> Tuple[int, Optional[Json]]:
        """One request below /line. Gives status and answer."""
        if path == "/line" and method == "POST":
            return 201, {"line": self._open(read_json(body))}
        if path not in ("/line", "/line/messages"):
            raise nothing_here()
        line = self._line(key)
        if path == "/line" and method == "DELETE":
            with self._ledger.changed:
                self._lines.remove(line)
            return 204, None
        if path == "/line/messages" and method == "POST":
            return 200, {"taken": self._take(line, read_json(body))}
        if path == "/line/messages" and method == "GET":
            after = number_in(query.get("after", "0"), "after")
            return 200, self._fetch(line, after, wait)
        raise not_known(method, "POST, DELETE" if path == "/line" else "GET, POST")

    def _open(self, hello: Json) -> str:
        key = hello.get("key")
        if not isinstance(key, str) or not hmac.compare_digest(key.encode(), self._key.encode()):
            raise _no_key("Send the robot's key in the hello, the part of its address after the #.")
        if hello.get("version") != VERSION:
            raise wrong("version", str(hello.get("version")), f"version {VERSION} of the protocol")
        if hello.get("type") != "hello" or hello.get("role") != "drive":
            raise wrong("role", str(hello.get("role")), "a hello of a script: drive")
        with self._ledger.changed:
            now = time.monotonic()
            self._lines = [line for line in self._lines if now - line.heard_at < SILENCE]
            del self._lines[: max(0, len(self._lines) - MOST_LINES + 1)]
            line = _Line(self._ledger.newest_event)
            line.transit(hello)
            self._lines.append(line)
            self._welcome(line, hello.get("since"))
        return line.key

    def _welcome(self, line: _Line, since: object) -> None:
        """The first message; then what was missed since an earlier line."""
        ledger, snapshot = self._ledger, self._pilot.snapshot
        gap: Optional[Json] = None
        stream, _, n = str(since or "").rpartition("-")
        if since is not None:
            if stream == ledger.stream and n.isdigit():
                line.n = int(n)
                gap, _events = ledger.events_after(line.n)
            else:
                gap = ledger.gap()
        if gap is not None:
            line.n = ledger.newest_event
        line.seq = snapshot["seq"]
        told = None if gap is not None else line.n
        welcome = {"type": "welcome", "version": 1, "stream": ledger.stream, "n": told}
        line.outbox.append({**welcome, "snapshot": snapshot})
        if gap is not None:
            line.outbox.append({"type": "gap", **gap})

    def _take(self, line: _Line, sent: Json) -> int:
        first, messages = sent.get("first"), sent.get("messages")
        if not isinstance(first, int) or not isinstance(messages, list):
            raise wrong("messages", str(messages)[:60], "a list of messages, and the first's number")
        with self._ledger.changed:
            for number, message in enumerate(messages[:MOST_MESSAGES], first):
                # What was taken before is not taken again; what skips one waits for that.
                if number == line.taken + 1:
                    line.taken = number
                    self._hear(line, message if isinstance(message, dict) else {})
            self._ledger.changed.notify_all()
            return line.taken

    def _hear(self, line: _Line, message: Json) -> None:
        if message.get("type") != "command":
            return
        key = message.get("key")
        try:
            order = order_of(message.get("command"))
            order.age += line.transit(message)
            record = self._ledger.submit(order, key)
            line.outbox.append({"type": "ack", "record": record})
        except Problem as problem:
            line.outbox.append({"type": "problem", "problem": problem.document, "key": key})

    def _fetch(self, line: _Line, after: int, wait: Wait) -> Json:
        with self._ledger.changed:
            come = max(0, min(after - line.first + 1, len(line.outbox)))
            del line.outbox[:come]
            line.first += come

        def has_news() -> bool:
            self._fill(line)
            return len(line.outbox) > 0

        wait(has_news)
        with self._ledger.changed:
            line.heard_at = time.monotonic()
            return {"first": line.first, "messages": line.outbox[:MOST_MESSAGES], "closed": None}

    def _fill(self, line: _Line) -> None:
        """What has happened since the line was told last. Endings come with readings as new as they."""
        now, snapshot = time.monotonic(), self._pilot.snapshot
        gap, events = self._ledger.events_after(line.n)
        is_due = len(events) > 0 or now - line.told_at >= PACE
        if snapshot["seq"] > line.seq and is_due and len(line.outbox) < MOST_MESSAGES:
            line.outbox.append({"type": "snapshot", "snapshot": snapshot})
            line.seq, line.told_at = snapshot["seq"], now
        if gap is not None:
            line.outbox.append({"type": "gap", **gap})
        for n, record in events:
            line.outbox.append({"type": "state", "n": n, "record": record})
        line.n = self._ledger.newest_event

    def _line(self, key: str) -> _Line:
        with self._ledger.changed:
            for line in self._lines:
                if hmac.compare_digest(key.encode(), line.key.encode()):
                    line.heard_at = self._ledger.heard_at = time.monotonic()
                    return line
        raise _no_key("This line is not open any more. Open another with POST /line.")


def _no_key(detail: str) -> Problem:
    return Problem(401, "not-authorised", detail, headers={"WWW-Authenticate": "Bearer"})
