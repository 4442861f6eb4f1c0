"""The HTTP API below /api/v1/robots/ID, as described in Corridor's docs/protocol.md."""

from __future__ import annotations

import hmac
import json
import re
import select
import socket
import time
import traceback
from functools import partial
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, Callable, Dict, Optional
from urllib.parse import parse_qsl, urlsplit

from .clocks import ScriptClocks
from .command_requests import CommandRequest, Json, parse_command, read_json
from .command_store import CommandStore
from .controller import Controller
from .long_poll import LongPollConnections
from .problems import Problem
from .validation import invalid, method_not_allowed, not_found, parse_number, parse_wait

MAX_BYTES = 16 * 1024
_KEY = re.compile(r"[A-Za-z0-9_-]{8,64}")
_CLOCK = re.compile(r"([A-Za-z0-9_-]{8,32}) (\d{1,15})")
_SINCE = re.compile(r"[A-Za-z0-9_]{8}-\d{1,15}")
_HEARTBEAT = 15.0
#: interval at which a waiting request looks whether its client is still there
_LOOK_SECONDS = 0.5
#: Headers that cross-origin requests may send.
_HEADERS = "Authorization, Content-Type, Idempotency-Key, Last-Event-ID, Script-Clock, Script-Name"


class RobotServer(ThreadingHTTPServer):
    """Serves one robot to clients that send its key."""

    daemon_threads = True
    #: length of the accept queue: a script may send a burst of commands
    request_queue_size = 128

    def __init__(
        self,
        address: Any,
        store: CommandStore,
        controller: Controller,
        robot_id: str,
        key: str,
        not_offered: Dict[str, str],
    ) -> None:
        """`not_offered`: unsupported features, each with a reason."""
        super().__init__(address, _Handler)
        self.not_offered = not_offered
        self.store = store
        self.controller = controller
        self.robot_id = robot_id
        self.key = key
        self.connections = LongPollConnections(store, controller, key)
        self.clocks = ScriptClocks()

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Does not log connection errors. All other errors have been answered."""


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server: RobotServer
    #: seconds for a request to arrive
    timeout = 30

    def do_GET(self) -> None:
        self._respond()

    do_POST = do_DELETE = do_PUT = do_PATCH = do_OPTIONS = do_GET

    def log_message(self, format: str, *args: Any) -> None:
        """Logs nothing, because headers and URLs may contain keys."""

    def _respond(self) -> None:
        try:
            body = self._body()
            if self.command == "OPTIONS":
                return self._send(204, None)
            self._route(body)
        except Problem as problem:
            kind = "application/problem+json"
            self._send(problem.status, problem.document, problem.headers, kind)
        except OSError:
            # The connection was lost, or a timeout passed.
            self.close_connection = True
        except Exception:
            # The stack trace is printed for the owner of the robot and not sent to the client.
            traceback.print_exc()
            detail = "The host failed to process the request. Try again later. Its log contains the details."
            self._send(500, Problem(500, "internal", detail).document)

    def _body(self) -> bytes:
        """Reads the whole body, so that the next request on this connection can be parsed."""
        length = self.headers.get("Content-Length", "0")
        if not length.isdigit() or "Transfer-Encoding" in self.headers:
            self.close_connection = True
            raise Problem(400, "bad-request", "The header Content-Length is missing or invalid. Send the length of the body.")
        remaining, body = int(length), b""
        while remaining > 0:
            chunk = self.rfile.read(min(remaining, 65_536))
            if chunk == b"":
                break
            remaining -= len(chunk)
            body = (body + chunk)[: MAX_BYTES + 1]
        if len(body) > MAX_BYTES:
            raise Problem(413, "too-large", f"The body has more than {MAX_BYTES // 1024} KiB. Send a smaller body.")
        return body

    def _route(self, body: bytes) -> None:
        parts = urlsplit(self.path)
        query = dict(parse_qsl(parts.query, keep_blank_values=True))
        match = re.fullmatch(r"/api/v1/robots/([^/]+)(/.*)?", parts.path)
        if match is None:
            raise not_found()
        if match[1] != self.server.robot_id:
            detail = "There is no robot with this id. Copy the address that the host printed."
            raise Problem(404, "no-robot", detail)
        path = match[2] or ""
        if path.startswith("/long-poll"):
            key = self._bearer() or ""
            wait = partial(self._wait, query)
            connections = self.server.connections
            return self._send(*connections.call(self.command, path, key, query, body, wait))
        self._check_key()
        record = re.fullmatch(r"/commands/([^/]+)", path)
        calls: Dict[str, Callable[[], None]]
        if path == "/sensors":
            calls = {"GET": lambda: self._sensors(query)}
        elif path == "/events":
            calls = {"GET": lambda: self._events(query)}
        elif path == "/features":
            calls = {"GET": self._features}
        elif path == "/maze":
            calls = {"GET": self._maze}
        elif path == "/commands":
            calls = {
                "GET": lambda: self._log(query),
                "POST": lambda: self._post_command(body),
                "DELETE": lambda: self._submit(CommandRequest({"action": "stop"})),
            }
        elif record is not None:
            seq = parse_number(record[1], "seq")
            calls = {"GET": lambda: self._record(seq, query), "DELETE": lambda: self._cancel(seq)}
        else:
            raise not_found()
        if self.command not in calls:
            raise method_not_allowed(self.command, ", ".join(calls))
        calls[self.command]()

    def _bearer(self) -> Optional[str]:
        kind, _, key = self.headers.get("Authorization", "").partition(" ")
        return key.strip() if kind.lower() == "bearer" else None

    def _check_key(self) -> None:
        key = self._bearer()
        if key is None or not hmac.compare_digest(key.encode(), self.server.key.encode()):
            detail = "Send the robot's key, the part of its address after the #, as: Authorization: Bearer KEY"
            raise Problem(401, "not-authorised", detail, headers={"WWW-Authenticate": "Bearer"})
        self.server.store.last_contact = time.monotonic()
        self._transit = self._transit_in(self.headers.get("Script-Clock"))

    def _transit_in(self, text: Optional[str]) -> float:
        """The delay of this request in ms, relative to the fastest request; 0 without a clock."""
        if text is None:
            return 0.0
        match = _CLOCK.fullmatch(text)
        if match is None:
            expected = "an id of 8 to 32 of A-Z a-z 0-9 - _, a space, and whole milliseconds"
            raise invalid("Script-Clock", text, expected)
        return self.server.clocks.transit(match[1], int(match[2]))

    # --- endpoints ---

    def _sensors(self, query: Dict[str, str]) -> None:
        after = -1 if "after" not in query else parse_number(query["after"], "after")
        self._wait(query, lambda: self.server.controller.snapshot["seq"] > after)
        self._send(200, self.server.controller.snapshot)

    def _features(self) -> None:
        missing = self.server.not_offered.items()
        self._send(
            200, {"notOffered": [{"feature": name, "reason": why} for name, why in missing]}
        )

    def _maze(self) -> None:
        raise Problem(404, "no-maze", "This robot has no map of its room. Use only its sensors.")

    def _post_command(self, body: bytes) -> None:
        kind = self.headers.get("Content-Type", "").partition(";")[0].strip().lower()
        if kind != "application/json":
            detail = 'Send the body as JSON, with the header "Content-Type: application/json".'
            raise Problem(415, "not-json", detail)
        request = parse_command(read_json(body))
        request.age += self._transit
        self._submit(request)

    def _submit(self, request: CommandRequest) -> None:
        key: Optional[str] = self.headers.get("Idempotency-Key")
        if key is not None and _KEY.fullmatch(key) is None:
            raise invalid("Idempotency-Key", key, "8 to 64 letters, digits, - or _")
        with self.server.store.changed:
            record = self.server.store.submit(request, key)
        self._accepted(record)

    def _cancel(self, seq: int) -> None:
        with self.server.store.changed:
            record = self.server.store.cancel(seq)
        self._accepted(record)

    def _record(self, seq: int, query: Dict[str, str]) -> None:
        with self.server.store.changed:
            entry = self.server.store.entry(seq)
        self._wait(query, lambda: entry.ended)
        with self.server.store.changed:
            record = entry.record()
        self._send(200, record)

    def _log(self, query: Dict[str, str]) -> None:
        after = parse_number(query.get("after", "0"), "after")
        with self.server.store.changed:
            commands = self.server.store.log(after)
        self._send(200, {"commands": commands})

    def _events(self, query: Dict[str, str]) -> None:
        store, controller = self.server.store, self.server.controller
        since = query.get("since") or self.headers.get("Last-Event-ID")
        if since is not None and _SINCE.fullmatch(since) is None:
            raise invalid("since", since, "STREAM-n of the last received state")
        if "wait" not in query:
            return self._stream(since)
        after = None if "after" not in query else parse_number(query["after"], "after")
        n = self._event_number(since)

        def has_changes() -> bool:
            has_states = since is None or n is None or store.newest_event > n
            return has_states or (after is not None and controller.snapshot["seq"] > after)

        self._wait(query, has_changes)
        with store.changed:
            gap, events = self._events_since(since, n)
            newest = store.newest_event
            snapshot = controller.snapshot
        self._send(
            200,
            {
                "since": f"{store.stream}-{newest}",
                "gap": gap,
                "states": [{"n": number, "record": record} for number, record in events],
                "snapshot": snapshot if after is None or snapshot["seq"] > after else None,
            },
        )

    def _stream(self, since: Optional[str]) -> None:
        store, controller = self.server.store, self.server.controller
        self._head(200, {"Content-Type": "text/event-stream", "Connection": "close"})
        self.close_connection = True
        with store.changed:
            gap, events = self._events_since(since, self._event_number(since))
            n, seq = store.newest_event, -1
        self._write(f"id: {store.stream}-{n}\n\n" if since is None else ": hello\n\n")
        if gap is not None:
            self._event("gap", gap, n)
        last_sent_at = time.monotonic()
        while True:
            for number, record in events:
                self._event("state", record, number)
                n = number
            snapshot = controller.snapshot
            if snapshot["seq"] > seq:
                self._event("snapshot", snapshot)
                seq, last_sent_at = snapshot["seq"], time.monotonic()
            if time.monotonic() - last_sent_at > _HEARTBEAT:
                self._write(": still here\n\n")
                last_sent_at = time.monotonic()
            with store.changed:
                store.changed.wait_for(
                    lambda: store.newest_event > n or controller.snapshot["seq"] > seq, _HEARTBEAT
                )
                gap, events = store.events_after(n)

    def _event_number(self, since: Optional[str]) -> Optional[int]:
        """The number of the last event that the reader has; None if `since` is of another stream."""
        stream, _, n = (since or f"{self.server.store.stream}-0").rpartition("-")
        return int(n) if stream == self.server.store.stream else None

    def _events_since(self, since: Optional[str], n: Optional[int]) -> Any:
        if since is None:
            return None, []
        return (self.server.store.gap(), []) if n is None else self.server.store.events_after(n)

    # --- waiting and responses ---

    def _wait(self, query: Dict[str, str], condition: Callable[[], bool]) -> None:
        wait = parse_wait(query)
        store = self.server.store
        with store.changed:
            # A waiting request counts as contact, so that a motion without an end continues.
            store.open_requests += 1
            ends_at = time.monotonic() + wait
            try:
                while not condition() and time.monotonic() < ends_at and not self._is_gone():
                    left = max(0.0, ends_at - time.monotonic())
                    store.changed.wait(min(_LOOK_SECONDS, left))
            finally:
                store.open_requests -= 1
                store.last_contact = time.monotonic()

    def _is_gone(self) -> bool:
        """Whether the client has closed its connection, so that nobody waits any more."""
        try:
            readable, _, _ = select.select([self.connection], [], [], 0)
            return bool(readable) and self.connection.recv(1, socket.MSG_PEEK) == b""
        except OSError:
            return True

    def _accepted(self, record: Json) -> None:
        location = f"/api/v1/robots/{self.server.robot_id}/commands/{record['seq']}"
        self._send(202, record, {"Location": location})

    def _send(
        self,
        status: int,
        document: Optional[Json],
        headers: Optional[Dict[str, str]] = None,
        kind: str = "application/json",
    ) -> None:
        body = b"" if document is None else json.dumps(document, separators=(",", ":")).encode()
        self._head(
            status, {"Content-Type": kind, "Content-Length": str(len(body)), **(headers or {})}
        )
        self.wfile.write(body)

    def _head(self, status: int, headers: Dict[str, str]) -> None:
        self.send_response(status)
        # Cross-origin requests are allowed, because every request requires the key.
        self.send_header("Access-Control-Allow-Origin", "*")
        self.send_header("Access-Control-Allow-Methods", "GET, POST, DELETE")
        self.send_header("Access-Control-Allow-Headers", _HEADERS)
        self.send_header("Cache-Control", "no-store")
        for name, value in headers.items():
            self.send_header(name, value)
        self.end_headers()

    def _event(self, event: str, data: Json, n: Optional[int] = None) -> None:
        number = "" if n is None else f"id: {self.server.store.stream}-{n}\n"
        self._write(f"{number}event: {event}\ndata: {json.dumps(data)}\n\n")

    def _write(self, text: str) -> None:
        self.wfile.write(text.encode())
        self.wfile.flush()

