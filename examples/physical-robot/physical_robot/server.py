"""The door: HTTP calls below /api/v1/robots/ID, as Corridor's docs/protocol.md lists them."""

from __future__ import annotations

import hmac
import json
import re
import time
import traceback
from functools import partial
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, Callable, Dict, Optional
from urllib.parse import parse_qsl, urlsplit

from .clocks import ScriptClocks
from .ledger import Ledger
from .lines import Lines
from .orders import Json, Order, order_of, read_json
from .pilot import Pilot
from .problems import Problem
from .reading import not_known, nothing_here, number_in, wait_in, wrong

MOST_BYTES = 16 * 1024
_KEY = re.compile(r"[A-Za-z0-9_-]{8,64}")
_CLOCK = re.compile(r"([A-Za-z0-9_-]{8,32}) (\d{1,15})")
_SINCE = re.compile(r"[A-Za-z0-9_]{8}-\d{1,15}")
_HEARTBEAT = 15.0
#: Headers that pages of other sites may send.
_HEADERS = "Authorization, Content-Type, Idempotency-Key, Last-Event-ID, Script-Clock, Script-Name"


class RobotServer(ThreadingHTTPServer):
    """Serves one robot to whoever has its key."""

    daemon_threads = True
    #: connections that may wait to be accepted: a script may send a burst of commands
    request_queue_size = 128

    def __init__(
        self,
        place: Any,
        ledger: Ledger,
        pilot: Pilot,
        robot_id: str,
        key: str,
        not_offered: Dict[str, str],
    ) -> None:
        """`not_offered`: what this robot cannot do, each with a sentence that says why."""
        super().__init__(place, _Handler)
        self.not_offered = not_offered
        self.ledger = ledger
        self.pilot = pilot
        self.robot_id = robot_id
        self.key = key
        self.lines = Lines(ledger, pilot, key)
        self.clocks = ScriptClocks()

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Lines break: that is no matter for a log. Everything else has been answered."""


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server: RobotServer
    #: seconds for a request to arrive
    timeout = 30

    def do_GET(self) -> None:
        self._answer()

    do_POST = do_DELETE = do_PUT = do_PATCH = do_OPTIONS = do_GET

    def log_message(self, format: str, *args: Any) -> None:
        """Nothing is written down: a header or an address could hold a key."""

    def _answer(self) -> None:
        try:
            body = self._body()
            if self.command == "OPTIONS":
                return self._send(204, None)
            self._route(body)
        except Problem as problem:
            kind = "application/problem+json"
            self._send(problem.status, problem.document, problem.headers, kind)
        except OSError:
            # The line broke, or nothing came on it in time.
            self.close_connection = True
        except Exception:
            # No stack for whoever asked: it goes to the owner of the robot.
            traceback.print_exc()
            detail = "It was noted on the robot's own machine. Try again in a moment."
            self._send(500, Problem(500, "internal", detail).document)

    def _body(self) -> bytes:
        """The whole body, so that the next request on this line begins where it should."""
        length = self.headers.get("Content-Length", "0")
        if not length.isdigit() or "Transfer-Encoding" in self.headers:
            self.close_connection = True
            raise Problem(400, "bad-request", "Send the body with its Content-Length.")
        rest, body = int(length), b""
        while rest > 0:
            piece = self.rfile.read(min(rest, 65_536))
            if piece == b"":
                break
            rest -= len(piece)
            body = (body + piece)[: MOST_BYTES + 1]
        if len(body) > MOST_BYTES:
            raise Problem(413, "too-large", f"A body may have {MOST_BYTES // 1024} KiB at most.")
        return body

    def _route(self, body: bytes) -> None:
        parts = urlsplit(self.path)
        query = dict(parse_qsl(parts.query, keep_blank_values=True))
        match = re.fullmatch(r"/api/v1/robots/([^/]+)(/.*)?", parts.path)
        if match is None:
            raise nothing_here()
        if match[1] != self.server.robot_id:
            detail = "There is no robot with this id. Copy the address that the host printed."
            raise Problem(404, "no-robot", detail)
        path = match[2] or ""
        if path.startswith("/line"):
            key = self._bearer() or ""
            wait = partial(self._wait, query)
            lines = self.server.lines
            return self._send(*lines.call(self.command, path, key, query, body, wait))
        self._check_key()
        record = re.fullmatch(r"/commands/([^/]+)", path)
        calls: Dict[str, Callable[[], None]]
        if path == "/sensors":
            calls = {"GET": lambda: self._sensors(query)}
        elif path == "/events":
            calls = {"GET": lambda: self._events(query)}
        elif path == "/features":
            calls = {"GET": self._features}
        elif path == "/commands":
            calls = {
                "GET": lambda: self._log(query),
                "POST": lambda: self._take(body),
                "DELETE": lambda: self._submit(Order({"action": "stop"})),
            }
        elif record is not None:
            seq = number_in(record[1], "seq")
            calls = {"GET": lambda: self._record(seq, query), "DELETE": lambda: self._cancel(seq)}
        else:
            raise nothing_here()
        if self.command not in calls:
            raise not_known(self.command, ", ".join(calls))
        calls[self.command]()

    def _bearer(self) -> Optional[str]:
        kind, _, key = self.headers.get("Authorization", "").partition(" ")
        return key.strip() if kind.lower() == "bearer" else None

    def _check_key(self) -> None:
        key = self._bearer()
        if key is None or not hmac.compare_digest(key.encode(), self.server.key.encode()):
            detail = "Send the robot's key, the part of its address after the #, as: Authorization: Bearer KEY"
            raise Problem(401, "not-authorised", detail, headers={"WWW-Authenticate": "Bearer"})
        self.server.ledger.heard_at = time.monotonic()
        self._transit = self._transit_in(self.headers.get("Script-Clock"))

    def _transit_in(self, text: Optional[str]) -> float:
        """ms that this request was on its way longer than the quickest one; 0 without a clock."""
        if text is None:
            return 0.0
        match = _CLOCK.fullmatch(text)
        if match is None:
            expected = "an id of 8 to 32 of A-Z a-z 0-9 - _, a space, and whole milliseconds"
            raise wrong("Script-Clock", text, expected)
        return self.server.clocks.transit(match[1], int(match[2]))

    # --- the calls ---

    def _sensors(self, query: Dict[str, str]) -> None:
        after = -1 if "after" not in query else number_in(query["after"], "after")
        self._wait(query, lambda: self.server.pilot.snapshot["seq"] > after)
        self._send(200, self.server.pilot.snapshot)

    def _features(self) -> None:
        missing = self.server.not_offered.items()
        self._send(
            200, {"notOffered": [{"feature": name, "reason": why} for name, why in missing]}
        )

    def _take(self, body: bytes) -> None:
        kind = self.headers.get("Content-Type", "").partition(";")[0].strip().lower()
        if kind != "application/json":
            detail = 'Send the body as JSON, with the header "Content-Type: application/json".'
            raise Problem(415, "not-json", detail)
        order = order_of(read_json(body))
        order.age += self._transit
        self._submit(order)

    def _submit(self, order: Order) -> None:
        key: Optional[str] = self.headers.get("Idempotency-Key")
        if key is not None and _KEY.fullmatch(key) is None:
            raise wrong("Idempotency-Key", key, "8 to 64 letters, digits, - or _")
        with self.server.ledger.changed:
            record = self.server.ledger.submit(order, key)
        self._accepted(record)

    def _cancel(self, seq: int) -> None:
        with self.server.ledger.changed:
            record = self.server.ledger.cancel(seq)
        self._accepted(record)

    def _record(self, seq: int, query: Dict[str, str]) -> None:
        with self.server.ledger.changed:
            entry = self.server.ledger.entry(seq)
        self._wait(query, lambda: entry.ended)
        with self.server.ledger.changed:
            record = entry.record()
        self._send(200, record)

    def _log(self, query: Dict[str, str]) -> None:
        after = number_in(query.get("after", "0"), "after")
        with self.server.ledger.changed:
            commands = self.server.ledger.log(after)
        self._send(200, {"commands": commands})

    def _events(self, query: Dict[str, str]) -> None:
        ledger, pilot = self.server.ledger, self.server.pilot
        since = query.get("since") or self.headers.get("Last-Event-ID")
        if since is not None and _SINCE.fullmatch(since) is None:
            raise wrong("since", since, "STREAM-n of the last state that was told")
        if "wait" not in query:
            return self._stream(since)
        after = None if "after" not in query else number_in(query["after"], "after")
        n = self._place(since)

        def has_news() -> bool:
            has_states = since is None or n is None or ledger.newest_event > n
            return has_states or (after is not None and pilot.snapshot["seq"] > after)

        self._wait(query, has_news)
        with ledger.changed:
            gap, events = self._news(since, n)
            newest = ledger.newest_event
            snapshot = pilot.snapshot
        self._send(
            200,
            {
                "since": f"{ledger.stream}-{newest}",
                "gap": gap,
                "states": [{"n": number, "record": record} for number, record in events],
                "snapshot": snapshot if after is None or snapshot["seq"] > after else None,
            },
        )

    def _stream(self, since: Optional[str]) -> None:
        ledger, pilot = self.server.ledger, self.server.pilot
        self._head(200, {"Content-Type": "text/event-stream", "Connection": "close"})
        self.close_connection = True
        with ledger.changed:
            gap, events = self._news(since, self._place(since))
            n, seq = ledger.newest_event, -1
        self._write(f"id: {ledger.stream}-{n}\n\n" if since is None else ": hello\n\n")
        if gap is not None:
            self._event("gap", gap, n)
        told_at = time.monotonic()
        while True:
            for number, record in events:
                self._event("state", record, number)
                n = number
            snapshot = pilot.snapshot
            if snapshot["seq"] > seq:
                self._event("snapshot", snapshot)
                seq, told_at = snapshot["seq"], time.monotonic()
            if time.monotonic() - told_at > _HEARTBEAT:
                self._write(": still here\n\n")
                told_at = time.monotonic()
            with ledger.changed:
                ledger.changed.wait_for(
                    lambda: ledger.newest_event > n or pilot.snapshot["seq"] > seq, _HEARTBEAT
                )
                gap, events = ledger.events_after(n)

    def _place(self, since: Optional[str]) -> Optional[int]:
        """The number of the event after which it goes on; None in a stream of before."""
        stream, _, n = (since or f"{self.server.ledger.stream}-0").rpartition("-")
        return int(n) if stream == self.server.ledger.stream else None

    def _news(self, since: Optional[str], n: Optional[int]) -> Any:
        if since is None:
            return None, []
        return (self.server.ledger.gap(), []) if n is None else self.server.ledger.events_after(n)

    # --- waiting and answering ---

    def _wait(self, query: Dict[str, str], is_there: Callable[[], bool]) -> None:
        wait = wait_in(query)
        ledger = self.server.ledger
        with ledger.changed:
            # Whoever waits is there: a motion without an end goes on meanwhile.
            ledger.listeners += 1
            try:
                ledger.changed.wait_for(is_there, wait)
            finally:
                ledger.listeners -= 1
                ledger.heard_at = time.monotonic()

    def _accepted(self, record: Json) -> None:
        place = f"/api/v1/robots/{self.server.robot_id}/commands/{record['seq']}"
        self._send(202, record, {"Location": place})

    def _send(
        self,
        status: int,
        document: Optional[Json],
        headers: Optional[Dict[str, str]] = None,
        kind: str = "application/json",
    ) -> None:
        body = b"" if document is None else json.dumps(document).encode()
        self._head(
            status, {"Content-Type": kind, "Content-Length": str(len(body)), **(headers or {})}
        )
        self.wfile.write(body)

    def _head(self, status: int, headers: Dict[str, str]) -> None:
        self.send_response(status)
        # Pages of other sites may use it: whoever has no key gets nothing.
        self.send_header("Access-Control-Allow-Origin", "*")
        self.send_header("Access-Control-Allow-Methods", "GET, POST, DELETE")
        self.send_header("Access-Control-Allow-Headers", _HEADERS)
        self.send_header("Cache-Control", "no-store")
        for name, value in headers.items():
            self.send_header(name, value)
        self.end_headers()

    def _event(self, event: str, data: Json, n: Optional[int] = None) -> None:
        number = "" if n is None else f"id: {self.server.ledger.stream}-{n}\n"
        self._write(f"{number}event: {event}\ndata: {json.dumps(data)}\n\n")

    def _write(self, text: str) -> None:
        self.wfile.write(text.encode())
        self.wfile.flush()

