"""How a script and a robot's host talk: tries, keys, ages and long polls, without any waiting in it.

Every command carries an idempotency key and is sent again with it, so a retry never moves the
robot twice. Each try says how old the wish is and when it was sent, so that one that comes late is not
done late.
"""

from __future__ import annotations

import json
import logging
import random
import time
import uuid
from urllib.parse import quote
from typing import Callable, List, Optional, Set, Tuple

from .actions import Action, has_no_end, plain
from .address import Address
from .command_times import CommandTimes
from .errors import ClosedError, CommandEndedError, NoAnswerError, RobotGoneError
from .problems import error_of, kind_of, may_pass, reason_of, sentence
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
from .requests import Answer, Json, Pause, Request, T, Talk

_FIRST_PAUSE = 0.25
_LONGEST_PAUSE = 10.0
#: One long poll. Short enough for filters that cut silent lines.
_LONG_POLL = 10.0
#: A reading waits so long for a newer one: robots report about 20 times a second while they move.
_READING_WAIT = 0.05
#: Readings of one decision are closer together than this.
_ONE_DECISION = 0.1
#: Beyond the wait that was asked for, the line counts as lost.
_GRACE = 10.0
#: Nothing was ever heard from this address: it may be wrong.
_FIRST_CONTACT = 10.0
#: A motion without an end is asked for its beginning so often.
_BEGIN_POLL = 0.1
#: A robot stops by itself when it hears nothing of its driver for 3 s.
_SIGN_OF_LIFE = 1.0
#: The host shows 40 characters of a name.
_LONGEST_NAME = 40
#: A command has so long to begin where it says nothing, in seconds: the host's own default.
_DEFAULT_TTL = 10.0
_LOG_PAGE = 200
_NO_COMMAND_YET = 999_999_999_999_999
#: The endings that are no success.
_HOW_IT_ENDED = {
    "cancelled": "was cancelled",
    "superseded": "was superseded",
    "expired": "expired",
}
#: The robot's page has left the relay.
_GONE = "The robot's page is closed or not connected"
_OPEN_AGAIN = "Open the page again and choose Remote. If it says Off, press Connect"

#: The page shows what it begins with as the script's language.
USER_AGENT = "Python-corridor/0.1"

_log = logging.getLogger("corridor")


class RobotTalk:
    """All that a script says to one robot. Each method gives a talk for a runner."""

    def __init__(
        self,
        address: Address,
        answer_timeout: float,
        finish_timeout: float,
        ttl: Optional[float] = None,
        clock: Callable[[], float] = time.monotonic,
        chance: Callable[[], float] = random.random,
        name: Optional[str] = None,
    ) -> None:
        self.address = address
        self.is_closed = False
        #: whether the robot goes on by itself with what this script asked for last
        self.drives_on = False
        self._answer_timeout = answer_timeout
        self._finish_timeout = finish_timeout
        self._ttl = ttl
        # Headers hold ASCII only.
        self._name = {} if not name else {"Script-Name": quote(name[:_LONGEST_NAME], safe=" ")}
        self._clock = clock
        self._times = CommandTimes(clock)
        self._chance = chance
        self._newest = -1
        #: the snapshot of one decision, which readings of it were given, and until when it holds
        self._decision: Optional[Snapshot] = None
        self._decided_on: Set[str] = set()
        self._decide_by = 0.0

    def greet(self) -> Talk[None]:
        """Whether the address leads to a robot, and the key fits."""
        limit = min(_FIRST_CONTACT, self._answer_timeout)
        yield from self._ask("GET", f"/commands?after={_NO_COMMAND_YET}", limit=limit)

    def do(self, action: Action) -> Talk[Command]:
        """Sends a command, and waits until it has ended; one without an end: until it has begun."""
        # A stop is wished for all the more where the network is slow.
        ttl = None if action == plain("stop") else self._ttl
        wish = action if ttl is None else {**action, "ttl": round(ttl * 1_000)}
        if not self._times.is_measured:
            yield from self.greet()
        answer = yield from self._ask("POST", "/commands", wish=wish, ttl=ttl or _DEFAULT_TTL)
        self.drives_on = has_no_end(action)
        return (yield from self._follow(_read(read_command, answer), action))

    def stop(self) -> Talk[Command]:
        """Ends the running command and drops all waiting ones, from every script."""
        return (yield from self.do(plain("stop")))

    def look(self, wait: float = _READING_WAIT) -> Talk[Snapshot]:
        """The newest report; waits up to so many seconds for one that is newer than the last."""
        deadline = self._clock() + self._answer_timeout
        is_waiting = False
        while True:
            if self._newest < 0:
                wait, path = _LONG_POLL, f"/sensors?wait={_LONG_POLL:g}"
            else:
                path = f"/sensors?after={self._newest}&wait={wait:g}"
            snapshot = _read(read_snapshot, (yield from self._ask("GET", path, wait=wait)))
            self._newest = snapshot.seq
            if snapshot.state != "gone":
                return snapshot
            if self._clock() >= deadline:
                raise RobotGoneError("robot-gone", _GONE, f"{_OPEN_AGAIN}.")
            if not is_waiting:
                _log.warning("%s. %s. Waiting for it.", _GONE, _OPEN_AGAIN)
            is_waiting = True
            wait = 1.0

    def read(self, name: str) -> Talk[Snapshot]:
        """The snapshot that a reading is of: one for all different readings of a decision."""
        decision = self._decision
        if decision is None or name in self._decided_on or self._clock() > self._decide_by:
            decision = yield from self.look()
            self._decision = decision
            self._decided_on = set()
            self._decide_by = self._clock() + _ONE_DECISION
        self._decided_on.add(name)
        return decision

    def wait_until(
        self, condition: Callable[[Sensors], object], timeout: Optional[float]
    ) -> Talk[Sensors]:
        """Reads the sensors again and again until the condition holds."""
        deadline = self._clock() + (self._finish_timeout if timeout is None else timeout)
        sensors = (yield from self.look()).sensors
        while not condition(sensors):
            rest = deadline - self._clock()
            if rest <= 0:
                raise NoAnswerError(
                    "timeout",
                    f"What wait_until() waits for did not come; the last reading was {sensors}",
                    "Give it more time with timeout=SECONDS, or check the condition.",
                )
            sensors = (yield from self.look(round(min(1.0, rest), 3))).sensors
        return sensors

    def wait(self, seconds: float) -> Talk[None]:
        """Lets time go by, and tells the robot meanwhile that this script is still there."""
        end = self._clock() + seconds
        while (rest := end - self._clock()) > 0:
            yield Pause(min(_SIGN_OF_LIFE, rest))
            yield from self.greet()

    def log(self) -> Talk[List[Command]]:
        """Every command that is kept, oldest first."""
        commands: List[Command] = []
        while True:
            after = commands[-1].seq if commands else 0
            page = _read(_commands, (yield from self._ask("GET", f"/commands?after={after}")))
            commands += page
            if len(page) < _LOG_PAGE:
                return commands

    def maze(self) -> Talk[Maze]:
        """The maze that the robot is in."""
        return _read(read_maze, (yield from self._ask("GET", "/maze")))

    def events(self, since: Optional[str], after: int) -> Talk[Tuple[str, Tuple[Event, ...]]]:
        """Where to go on from, and what happened after `since`; the newest report where it is None."""
        wait = 0.0 if since is None else _LONG_POLL
        where = "" if since is None else f"&since={since}&after={after}"
        path = f"/events?wait={wait:g}{where}"
        page = yield from self._ask("GET", path, wait=wait)
        return _read(_event_page, page)

    def _follow(self, command: Command, action: Action) -> Talk[Command]:
        ends = not has_no_end(action)
        deadline = self._clock() + self._finish_timeout
        while not command.ended and (ends or command.state != "started"):
            if self._clock() >= deadline:
                raise NoAnswerError(
                    "timeout",
                    f"The robot does not finish command {command.seq} ({command.action})",
                    "Check that the robot's page is open, connected and not paused.",
                )
            wait = _LONG_POLL if ends else _BEGIN_POLL
            path = f"/commands/{command.seq}?wait={wait:g}"
            command = _read(read_command, (yield from self._ask("GET", path, wait=wait)))
        # Another command took its place: that is how a motion without an end is meant to end.
        was_replaced = command.state == "superseded" and not ends
        if command.state in _HOW_IT_ENDED and not was_replaced:
            raise CommandEndedError(
                command.state,
                f"Command {command.seq} ({command.action}) {_HOW_IT_ENDED[command.state]}",
                sentence(command.reason or "somebody else drives this robot too"),
            )
        return command

    def _ask(
        self,
        method: str,
        path: str,
        *,
        wish: Optional[Action] = None,
        ttl: float = 0.0,
        wait: float = 0.0,
        limit: Optional[float] = None,
    ) -> Talk[Json]:
        """One request, tried again while the network or the host has a bad moment."""
        headers = {
            "Authorization": f"Bearer {self.address.key}",
            "Accept": "application/json",
            "User-Agent": USER_AGENT,
            **self._name,
        }
        if wish is not None:
            headers["Content-Type"] = "application/json"
            headers["Idempotency-Key"] = uuid.uuid4().hex
        # Whatever else a script asks for begins a new decision.
        self._decision = None
        began = self._clock()
        limit = self._answer_timeout if limit is None else limit
        tries = 0
        doubts = 0
        failed_at = began
        while True:
            if self.is_closed:
                raise ClosedError("closed", "This robot was closed", "Make a new Robot to go on.")
            sent = self._clock()
            answer = yield Request(
                method=method,
                url=self.address.api + path,
                headers={**headers, **self._times.header()},
                body=None if wish is None else _aged(wish, self._times.age(began)),
                timeout=wait + _GRACE,
            )
            if answer is None:
                raise TypeError("whoever runs a talk answers its requests")
            passed = self._clock() - sent
            if 200 <= answer.status < 300:
                said = _parse(answer)
                if wait == 0:
                    self._times.answered(passed)
                return said
            if kind_of(answer) == "too-late":
                self._times.answered(passed)
                if doubts < 2 and self._clock() - began < ttl:
                    # It is not: the answer has shown a quicker way, or this computer has slept and its
                    # clock stood still. Then another one is measured.
                    doubts += 1
                    if doubts == 2:
                        self._times.begin_anew()
                        yield from self.greet()
                    continue
            if not may_pass(answer):
                raise error_of(answer)
            if tries == 0:
                failed_at = self._clock()
            # After a short cut a few short pauses lead to no long one.
            lost = max(_FIRST_PAUSE, 2 * (self._clock() - failed_at))
            pause = self._chance() * min(_LONGEST_PAUSE, _FIRST_PAUSE * 2**tries, lost)
            pause = max(pause, answer.retry_after or 0.0)
            tries += 1
            if self._clock() - began + pause > limit:
                raise NoAnswerError(
                    "timeout",
                    f"The robot's host does not answer: {reason_of(answer)}",
                    f"Check the network, and that {self.address.origin} is where the robot is.",
                )
            if tries == 2:
                _log.warning("The robot's host does not answer (%s). Trying again.", reason_of(answer))
            yield Pause(pause)


def _aged(wish: Action, age: int) -> bytes:
    """A wish as it travels; `age` in ms."""
    return json.dumps({**wish, "age": age} if age > 0 else wish).encode()


def _commands(answer: Json) -> List[Command]:
    return [read_command(record) for record in answer["commands"]]


def _event_page(page: Json) -> Tuple[str, Tuple[Event, ...]]:
    return page["since"], read_events(page)


def _parse(answer: Answer) -> Json:
    try:
        return json.loads(answer.body)
    except ValueError:
        raise error_of(answer) from None


def _read(reader: Callable[[Json], T], answer: Json) -> T:
    """What the answer says; one of another shape did not come from a robot's host."""
    try:
        return reader(answer)
    except (KeyError, TypeError, AttributeError):
        raise error_of(Answer(200)) from None
