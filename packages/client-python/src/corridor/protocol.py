"""The protocol between a script and a robot's host, without I/O: retries, keys, ages and long polls.

Each command has an idempotency key, so that a retry never moves the robot twice. Each attempt contains
its send time and the age of the command, so that the robot never executes it late.
"""

from __future__ import annotations

import json
import logging
import random
import time
import uuid
from urllib.parse import quote
from typing import Callable, List, Optional, Set, Tuple

from .actions import Action, is_endless, plain
from .address import Address
from .command_times import CommandTimes
from .errors import ClosedError, CommandEndedError, NoAnswerError, RobotGoneError
from .problems import as_sentence, error_of, is_temporary, problem_type, reason_of
from .reports import (
    Command,
    Event,
    Maze,
    Sensors,
    Snapshot,
    read_command,
    read_events,
    read_maze,
    read_snapshot,
)
from .requests import Response, Json, Delay, Request, T, Exchange

_FIRST_DELAY = 0.25
_MAX_DELAY = 10.0
#: Seconds of one long poll. Short enough for proxies that close idle connections.
_LONG_POLL = 10.0
#: Seconds of one long poll for the end of a command, so that a silent robot is reported soon.
_PROGRESS_POLL = 1.5
#: Seconds without progress of a command after which the reason is printed.
_SILENCE = 3.0
#: Seconds to wait for a newer snapshot: robots send about 20 a second while they move.
_READING_WAIT = 0.05
#: Maximum age of the snapshot of one decision in seconds.
_DECISION_TIME = 0.1
#: Seconds until a request is given up, in addition to its wait.
_RESPONSE_TIMEOUT = 10.0
#: Timeout in seconds of the first request: the address may be wrong.
_FIRST_TIMEOUT = 10.0
#: Seconds of one poll until an endless motion has started.
_START_POLL = 0.1
#: Seconds between requests while waiting. A robot stops after 3 s without a request of its driver.
_KEEPALIVE = 1.0
#: Displayed characters of a name.
_MAX_NAME = 40
#: The host's default time to live in seconds.
_DEFAULT_TTL = 10.0
_LOG_PAGE = 200
_NO_COMMAND_YET = 999_999_999_999_999
#: Endings that are errors.
_FAILED_ENDINGS = {
    "cancelled": "was cancelled",
    "superseded": "was superseded",
    "expired": "expired",
}
_GONE = "The robot's page is closed or not connected"
_REOPEN = (
    "Open the page again and choose Remote. If it says Off, press Connect. "
    "If you closed its tab, copy the new address into the script"
)

#: The page shows its first word as the script's language.
USER_AGENT = "Python-corridor/0.1"

_log = logging.getLogger("corridor")


class RobotProtocol:
    """The exchanges of one script with one robot, to be run by `run` or `run_async`."""

    def __init__(
        self,
        address: Address,
        answer_timeout: float,
        finish_timeout: float,
        ttl: Optional[float] = None,
        clock: Callable[[], float] = time.monotonic,
        rand: Callable[[], float] = random.random,
        name: Optional[str] = None,
    ) -> None:
        self.address = address
        self.is_closed = False
        #: whether the last command of this script started an endless motion
        self.has_endless_motion = False
        #: number of the script's newest command
        self._newest_command = 0
        self._answer_timeout = answer_timeout
        self._finish_timeout = finish_timeout
        self._ttl = ttl
        # HTTP headers are ASCII.
        self._name = {} if not name else {"Script-Name": quote(name[:_MAX_NAME], safe=" ")}
        self._clock = clock
        self._times = CommandTimes(clock)
        self._rand = rand
        self._newest_seq = -1
        #: the snapshot of one decision, the readings that were taken from it, and its expiry
        self._decision: Optional[Snapshot] = None
        self._decision_reads: Set[str] = set()
        self._decision_expires = 0.0

    def check_access(self) -> Exchange[None]:
        """Raises an error unless the robot exists and its host accepts the key."""
        yield from self._probe(min(_FIRST_TIMEOUT, self._answer_timeout))

    def _probe(self, limit: Optional[float] = None) -> Exchange[None]:
        """The smallest request. `limit`: seconds for all attempts; default: the answer timeout."""
        yield from self._request("GET", f"/commands?after={_NO_COMMAND_YET}", limit=limit)

    def execute(self, action: Action) -> Exchange[Command]:
        """Sends a command, and waits until it has ended; an endless motion, until it has started."""
        # A stop must not expire early on a slow network.
        ttl = None if action == plain("stop") else self._ttl
        order = action if ttl is None else {**action, "ttl": round(ttl * 1_000)}
        if not self._times.is_measured:
            yield from self.check_access()
        ttl = ttl or _DEFAULT_TTL
        self._newest_command += 1
        number, first_sent_at, is_repeated = self._newest_command, self._clock(), False
        while True:
            response = yield from self._request(
                "POST", "/commands", order=order, ttl=ttl, first_sent_at=first_sent_at
            )
            self.has_endless_motion = is_endless(action)
            command = yield from self._wait_for_end(_read(read_command, response), action)
            # The round trips before it were longer than this one, so the host took it for older than
            # it is. Less early, it expired by its round trip, and its reason helps. A later command
            # must not be overtaken.
            age = self._clock() - first_sent_at
            is_early = age < ttl / 2 and number == self._newest_command
            if command.state != "expired" or is_repeated or not is_early:
                return _successful(command, action)
            is_repeated = True

    def stop(self) -> Exchange[Command]:
        """Cancels the running command and all waiting ones, from every script."""
        return (yield from self.execute(plain("stop")))

    def next_snapshot(self, wait: float = _READING_WAIT) -> Exchange[Snapshot]:
        """The newest snapshot; waits up to `wait` seconds for one that is newer than the last."""
        deadline = self._clock() + self._answer_timeout
        is_waiting = False
        while True:
            if self._newest_seq < 0:
                wait, path = _LONG_POLL, f"/sensors?wait={_LONG_POLL:g}"
            else:
                path = f"/sensors?after={self._newest_seq}&wait={wait:g}"
            snapshot = _read(read_snapshot, (yield from self._request("GET", path, wait=wait)))
            self._newest_seq = snapshot.seq
            if snapshot.state != "gone":
                return snapshot
            if self._clock() >= deadline:
                raise RobotGoneError("robot-gone", _GONE, f"{_REOPEN}.")
            if not is_waiting:
                _log.warning("%s. %s. Waiting for the page.", _GONE, _REOPEN)
            is_waiting = True
            wait = 1.0

    def snapshot_for(self, name: str) -> Exchange[Snapshot]:
        """The snapshot for a reading: the same one for all different readings of a decision."""
        decision = self._decision
        if decision is None or name in self._decision_reads or self._clock() > self._decision_expires:
            decision = yield from self.next_snapshot()
            self._decision = decision
            self._decision_reads = set()
            self._decision_expires = self._clock() + _DECISION_TIME
        self._decision_reads.add(name)
        return decision

    def wait_until(
        self, condition: Callable[[Sensors], object], timeout: Optional[float]
    ) -> Exchange[Sensors]:
        """Reads the sensors until the condition is true."""
        deadline = self._clock() + (self._finish_timeout if timeout is None else timeout)
        sensors = (yield from self.next_snapshot()).sensors
        while not condition(sensors):
            rest = deadline - self._clock()
            if rest <= 0:
                raise NoAnswerError(
                    "timeout",
                    f"The condition of wait_until() did not become true; the last reading was {sensors}",
                    "Increase timeout=SECONDS, or check the condition.",
                )
            sensors = (yield from self.next_snapshot(round(min(1.0, rest), 3))).sensors
        return sensors

    def wait(self, seconds: float) -> Exchange[None]:
        """Waits, and sends requests meanwhile, so that the robot does not stop."""
        end = self._clock() + seconds
        while (rest := end - self._clock()) > 0:
            yield Delay(min(_KEEPALIVE, rest))
            yield from self._probe()

    def log(self) -> Exchange[List[Command]]:
        """Every command that the host stores, oldest first."""
        commands: List[Command] = []
        while True:
            after = commands[-1].seq if commands else 0
            page = _read(_commands, (yield from self._request("GET", f"/commands?after={after}")))
            commands += page
            if len(page) < _LOG_PAGE:
                return commands

    def maze(self) -> Exchange[Maze]:
        """The robot's maze."""
        return _read(read_maze, (yield from self._request("GET", "/maze")))

    def events(self, since: Optional[str], after: int) -> Exchange[Tuple[str, Tuple[Event, ...]]]:
        """The next `since`, and the events after `since`; the newest snapshot if it is None."""
        wait = 0.0 if since is None else _LONG_POLL
        query = "" if since is None else f"&since={since}&after={after}"
        path = f"/events?wait={wait:g}{query}"
        page = yield from self._request("GET", path, wait=wait)
        return _read(_event_page, page)

    def _wait_for_end(self, command: Command, action: Action) -> Exchange[Command]:
        ends = not is_endless(action)
        deadline = self._clock() + self._finish_timeout
        silent_since: Optional[float] = None
        is_reported = False
        while not command.ended and (ends or command.state != "started"):
            if self._clock() >= deadline:
                raise NoAnswerError(
                    "timeout",
                    f"The robot did not finish command {command.seq} ({command.action})",
                    "Check that the robot's page is open, connected and not paused.",
                )
            asked_at = self._clock()
            wait = _PROGRESS_POLL if ends else _START_POLL
            path = f"/commands/{command.seq}?wait={wait:g}"
            command = _read(read_command, (yield from self._request("GET", path, wait=wait)))
            # The host sends a reason before the end if the robot's page is closed, paused or asleep.
            if command.ended or command.reason is None:
                silent_since, is_reported = None, False
                continue
            silent_since = asked_at if silent_since is None else silent_since
            if not is_reported and self._clock() - silent_since >= _SILENCE:
                _log.warning("%s", as_sentence(command.reason))
                is_reported = True
        return command

    def _request(
        self,
        method: str,
        path: str,
        *,
        order: Optional[Action] = None,
        ttl: float = 0.0,
        wait: float = 0.0,
        limit: Optional[float] = None,
        first_sent_at: Optional[float] = None,
    ) -> Exchange[Json]:
        """Sends a request, and repeats it after temporary failures."""
        headers = {
            "Authorization": f"Bearer {self.address.key}",
            "Accept": "application/json",
            "User-Agent": USER_AGENT,
            **self._name,
        }
        if order is not None:
            headers["Content-Type"] = "application/json"
            headers["Idempotency-Key"] = uuid.uuid4().hex
        # Every other request ends the decision.
        self._decision = None
        first_sent_at = self._clock() if first_sent_at is None else first_sent_at
        limit = self._answer_timeout if limit is None else limit
        attempts = 0
        false_expiries = 0
        failed_at = first_sent_at
        while True:
            if self.is_closed:
                raise ClosedError("closed", "This robot was closed", "Create a new Robot to continue.")
            sent = self._clock()
            response = yield Request(
                method=method,
                url=self.address.api + path,
                headers={**headers, **self._times.header()},
                body=None if order is None else _encode(order, self._times.age(first_sent_at)),
                timeout=wait + _RESPONSE_TIMEOUT,
            )
            if response is None:
                raise TypeError("The runner must send a response to each request")
            round_trip = self._clock() - sent
            if 200 <= response.status < 300:
                body = _parse(response)
                if wait == 0:
                    self._times.answered(round_trip)
                return body
            if problem_type(response) == "too-late":
                self._times.answered(round_trip)
                if false_expiries < 2 and self._clock() - first_sent_at < ttl:
                    # It has not expired: either the response has shown a shorter round trip, or the
                    # clock stopped while this computer slept. Then measure with a new clock.
                    false_expiries += 1
                    if false_expiries == 2:
                        self._times.reset()
                        yield from self._probe()
                    continue
            if not is_temporary(response):
                raise error_of(response, self.address)
            if attempts == 0:
                failed_at = self._clock()
            # A short outage never leads to a long delay.
            since_failure = max(_FIRST_DELAY, 2 * (self._clock() - failed_at))
            delay = self._rand() * min(_MAX_DELAY, _FIRST_DELAY * 2**attempts, since_failure)
            delay = max(delay, response.retry_after or 0.0)
            attempts += 1
            if self._clock() - first_sent_at + delay > limit:
                raise NoAnswerError(
                    "timeout",
                    f"The robot's host does not respond: {reason_of(response)}",
                    f"Check the network, and that the robot is at {self.address.origin}.",
                )
            if attempts == 2:
                _log.warning(
                    "The robot's host does not respond at %s (%s). Retrying.",
                    self.address.origin,
                    reason_of(response),
                )
            yield Delay(delay)


def _successful(command: Command, action: Action) -> Command:
    # Endless motions end normally when another command replaces them.
    was_replaced = command.state == "superseded" and is_endless(action)
    if command.state in _FAILED_ENDINGS and not was_replaced:
        raise CommandEndedError(
            command.state,
            f"Command {command.seq} ({command.action}) {_FAILED_ENDINGS[command.state]}",
            as_sentence(command.reason or "another script drives this robot as well"),
        )
    return command


def _encode(order: Action, age: int) -> bytes:
    """The request body of a command; `age` in ms."""
    return json.dumps({**order, "age": age} if age > 0 else order).encode()


def _commands(response: Json) -> List[Command]:
    return [read_command(record) for record in response["commands"]]


def _event_page(page: Json) -> Tuple[str, Tuple[Event, ...]]:
    return page["since"], read_events(page)


def _parse(response: Response) -> Json:
    try:
        return json.loads(response.body)
    except ValueError:
        raise error_of(response) from None


def _read(reader: Callable[[Json], T], response: Json) -> T:
    """The value of a body; an unexpected one does not come from a robot's host."""
    try:
        return reader(response)
    except (KeyError, TypeError, AttributeError):
        raise error_of(Response(200)) from None
