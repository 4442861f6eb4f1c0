"""Long-poll connections: the messages of a WebSocket over plain HTTPS requests.

A script posts its messages, and receives the messages of the host with long-poll requests. Each
side numbers its messages 1, 2, 3, so that a failed request can be repeated.
"""

from __future__ import annotations

import hmac
import secrets
import time
from typing import Callable, Dict, List, Optional, Tuple

from .clocks import ScriptClock
from .command_requests import Json, is_within, parse_command, read_json
from .command_store import CommandStore
from .controller import Controller
from .problems import Problem
from .validation import invalid, method_not_allowed, not_found, parse_number

VERSION = 1
MAX_MESSAGES = 64
MAX_CONNECTIONS = 16
#: Maximum time of a script's clock, in ms.
MAX_SENT_AT = 999_999_999_999_999
#: Seconds without a request after which a connection is closed.
CONNECTION_TIMEOUT = 15.0
#: Minimum interval between two snapshots, in seconds.
SNAPSHOT_INTERVAL = 0.1

Wait = Callable[[Callable[[], bool]], None]


class _Connection:
    def __init__(self, n: int) -> None:
        self.key = "con_" + secrets.token_urlsafe(16)
        self.last_contact = time.monotonic()
        #: number of the last message received from the script
        self.received = 0
        #: messages that the script has not acknowledged, and the number of the first of them
        self.outbox: List[Json] = []
        self.first = 1
        #: numbers of the last event and the last snapshot in the outbox
        self.n = n
        self.seq = -1
        self.last_sent_at = 0.0
        self.clock = ScriptClock()

    def transit(self, message: Json) -> float:
        """The delay of a message in ms, relative to the fastest message; 0 without a timestamp."""
        sent_at = message.get("sentAt")
        if sent_at is None:
            return 0.0
        if not is_within(sent_at, 0, MAX_SENT_AT):
            raise invalid("sentAt", str(sent_at), f"milliseconds from 0 to {MAX_SENT_AT}")
        return self.clock.transit(sent_at)


class LongPollConnections:
    """All open connections, guarded by the lock of the store."""

    def __init__(self, store: CommandStore, controller: Controller, key: str) -> None:
        self._store = store
        self._controller = controller
        self._key = key
        self._connections: List[_Connection] = []

    def call(
        self, method: str, path: str, key: str, query: Dict[str, str], body: bytes, wait: Wait
    ) -> Tuple[int, Optional[Json]]:
        """Handles a request below /long-poll. Returns the status and the response."""
        if path == "/long-poll" and method == "POST":
            return 201, {"key": self._open(read_json(body))}
        if path not in ("/long-poll", "/long-poll/messages"):
            raise not_found()
        connection = self._find(key)
        if path == "/long-poll" and method == "DELETE":
            with self._store.changed:
                self._connections.remove(connection)
            return 204, None
        if path == "/long-poll/messages" and method == "POST":
            return 200, {"taken": self._receive(connection, read_json(body))}
        if path == "/long-poll/messages" and method == "GET":
            after = parse_number(query.get("after", "0"), "after")
            return 200, self._fetch(connection, after, wait)
        raise method_not_allowed(method, "POST, DELETE" if path == "/long-poll" else "GET, POST")

    def _open(self, hello: Json) -> str:
        key = hello.get("key")
        if not isinstance(key, str) or not hmac.compare_digest(key.encode(), self._key.encode()):
            raise _no_key("Send the robot's key in the hello, the part of its address after the #.")
        if hello.get("version") != VERSION:
            raise invalid("version", str(hello.get("version")), f"version {VERSION} of the protocol")
        if hello.get("type") != "hello" or hello.get("role") != "drive":
            raise invalid("role", str(hello.get("role")), "a hello of a script: drive")
        with self._store.changed:
            now = time.monotonic()
            self._connections = [
                connection
                for connection in self._connections
                if now - connection.last_contact < CONNECTION_TIMEOUT
            ]
            del self._connections[: max(0, len(self._connections) - MAX_CONNECTIONS + 1)]
            connection = _Connection(self._store.newest_event)
            connection.transit(hello)
            self._connections.append(connection)
            self._welcome(connection, hello.get("since"))
        return connection.key

    def _welcome(self, connection: _Connection, since: object) -> None:
        """Sends the welcome, and events since an earlier connection or a gap."""
        store, snapshot = self._store, self._controller.snapshot
        gap: Optional[Json] = None
        stream, _, n = str(since or "").rpartition("-")
        if since is not None:
            if stream == store.stream and n.isdigit():
                connection.n = int(n)
                gap, _events = store.events_after(connection.n)
            else:
                gap = store.gap()
        if gap is not None:
            connection.n = store.newest_event
        connection.seq = snapshot["seq"]
        number = None if gap is not None else connection.n
        welcome = {"type": "welcome", "version": 1, "stream": store.stream, "n": number}
        connection.outbox.append({**welcome, "snapshot": snapshot})
        if gap is not None:
            connection.outbox.append({"type": "gap", **gap})

    def _receive(self, connection: _Connection, batch: Json) -> int:
        first, messages = batch.get("first"), batch.get("messages")
        if not isinstance(first, int) or not isinstance(messages, list):
            expected = "a list of messages, and the number of the first"
            raise invalid("messages", str(messages)[:60], expected)
        with self._store.changed:
            for number, message in enumerate(messages[:MAX_MESSAGES], first):
                # Ignores messages that were received before, and messages after a missing one.
                if number == connection.received + 1:
                    connection.received = number
                    self._handle(connection, message if isinstance(message, dict) else {})
            self._store.changed.notify_all()
            return connection.received

    def _handle(self, connection: _Connection, message: Json) -> None:
        if message.get("type") != "command":
            return
        key = message.get("key")
        try:
            request = parse_command(message.get("command"))
            request.age += connection.transit(message)
            record = self._store.submit(request, key)
            connection.outbox.append({"type": "ack", "record": record})
        except Problem as problem:
            connection.outbox.append({"type": "problem", "problem": problem.document, "key": key})

    def _fetch(self, connection: _Connection, after: int, wait: Wait) -> Json:
        with self._store.changed:
            acknowledged = max(0, min(after - connection.first + 1, len(connection.outbox)))
            del connection.outbox[:acknowledged]
            connection.first += acknowledged

        def has_changes() -> bool:
            self._collect(connection)
            return len(connection.outbox) > 0

        wait(has_changes)
        with self._store.changed:
            connection.last_contact = time.monotonic()
            messages = connection.outbox[:MAX_MESSAGES]
            return {"first": connection.first, "messages": messages, "closed": None}

    def _collect(self, connection: _Connection) -> None:
        """Adds new events to the outbox, after a snapshot that is not older than the events."""
        now, snapshot = time.monotonic(), self._controller.snapshot
        gap, events = self._store.events_after(connection.n)
        is_due = len(events) > 0 or now - connection.last_sent_at >= SNAPSHOT_INTERVAL
        if snapshot["seq"] > connection.seq and is_due and len(connection.outbox) < MAX_MESSAGES:
            connection.outbox.append({"type": "snapshot", "snapshot": snapshot})
            connection.seq, connection.last_sent_at = snapshot["seq"], now
        if gap is not None:
            connection.outbox.append({"type": "gap", **gap})
        for n, record in events:
            connection.outbox.append({"type": "state", "n": n, "record": record})
        connection.n = self._store.newest_event

    def _find(self, key: str) -> _Connection:
        with self._store.changed:
            for connection in self._connections:
                if hmac.compare_digest(key.encode(), connection.key.encode()):
                    connection.last_contact = self._store.last_contact = time.monotonic()
                    return connection
        raise _no_key("This connection is closed. Open another one with POST /long-poll.")


def _no_key(detail: str) -> Problem:
    return Problem(401, "not-authorised", detail, headers={"WWW-Authenticate": "Bearer"})
