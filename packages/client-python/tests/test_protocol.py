"""Retries, keys, delays and errors, with virtual time and prepared responses."""

import json
from typing import Any, List, Optional, Union

import pytest
from corridor import (
    AddressError,
    ClosedError,
    CommandEndedError,
    CommandError,
    NoAnswerError,
    NotAuthorisedError,
    RobotGoneError,
)
from corridor.actions import go_forward
from corridor.address import parse_address
from corridor.reports import Command, Sensors
from corridor.requests import Response, Delay, Request, T, Exchange
from corridor.protocol import RobotProtocol

KEY = "drv_AAAAAAAAAAAAAAAAAAAAAA"
LOST = Response(0, error="connection refused")


def record(state: str, reason: Optional[str] = None, seq: int = 7) -> Response:
    return Response(
        202,
        json.dumps(
            {
                "seq": seq,
                "key": None,
                "action": "move",
                "command": {"action": "move", "distance": 100},
                "state": state,
                "reason": reason,
                "acceptedAt": "2026-01-01T00:00:00.000Z",
                "pose": None if state == "accepted" else {"x": 50, "y": 150, "heading": 0},
                "distance": None if state == "accepted" else 100,
                "duplicate": False,
            }
        ).encode(),
    )


def snapshot(
    seq: int, front: float = 50, state: str = "running", right: float = 50
) -> Response:
    sensors = {"front": front, "right": right, "back": 50, "left": 50}
    pose = {"x": 50, "y": 50, "heading": 0}
    seen = {"seq": seq, "tick": seq, "state": state, "driver": "remote", "sensors": sensors}
    rest = {"motion": "stop", "bumps": 0, "bumping": False, "goalReached": False, "command": None}
    return Response(200, json.dumps({**seen, "pose": pose, **rest, "line": None}).encode())


def problem(status: int, kind: str, detail: str = "Fix it so.", **more: Any) -> Response:
    document = {"type": f"/problems/{kind}", "title": "No", "status": status, "detail": detail}
    return Response(status, json.dumps({**document, "errors": [], **more}).encode())


class Harness:
    """A protocol, its responses in order, its requests and its delays."""

    def __init__(
        self,
        *answers: Union[Response, float],
        rand: float = 1.0,
        latency: float = 0.0,
        ttl: Optional[float] = None,
        is_checked: bool = True,
    ) -> None:
        self.now = 100.0
        self.latency = 0.0
        #: responses, and numbers of seconds before the next one
        self.answers = list(answers)
        self.requests: List[Request] = []
        self.delays: List[float] = []
        address = parse_address(f"http://robots.example/r/abc#{KEY}")
        self.protocol = RobotProtocol(
            address, 30.0, 60.0, ttl, clock=lambda: self.now, rand=lambda: rand
        )
        if is_checked:
            self.answers = [Response(200, b"{}")]
            self.run(self.protocol.check_access())
            self.answers, self.requests = list(answers), []
        self.latency = latency

    def run(self, exchange: Exchange[T]) -> T:
        try:
            step = next(exchange)
            while True:
                if isinstance(step, Delay):
                    self.delays.append(step.seconds)
                    self.now += step.seconds
                    step = exchange.send(None)
                else:
                    self.requests.append(step)
                    step = exchange.send(self._answer())
        except StopIteration as end:
            result: T = end.value
            return result

    def _answer(self) -> Response:
        self.now += self.latency
        answer = self.answers.pop(0) if len(self.answers) > 1 else self.answers[0]
        while isinstance(answer, float):
            self.now += answer
            answer = self.answers.pop(0) if len(self.answers) > 1 else self.answers[0]
        return answer

    def move(self) -> Command:
        return self.run(self.protocol.execute(go_forward(100)))


def test_a_move_waits_until_the_robot_has_finished_it() -> None:
    harness = Harness(record("accepted"), record("started"), record("completed"))
    command = harness.move()
    assert command.state == "completed" and command.distance == 100 and command
    assert [request.url.split("/abc")[1] for request in harness.requests] == [
        "/commands",
        "/commands/7?wait=1.5",
        "/commands/7?wait=1.5",
    ]
    assert json.loads(harness.requests[0].body or b"") == {"action": "move", "distance": 100}


def test_a_collision_is_not_an_error() -> None:
    command = Harness(record("collided")).move()
    assert command.collided
    assert not command


def test_an_endless_motion_waits_until_it_has_started() -> None:
    harness = Harness(record("accepted"), record("delivered"), record("started"))
    assert harness.run(harness.protocol.execute(go_forward(None))).state == "started"
    assert harness.protocol.has_endless_motion
    assert harness.requests[1].url.endswith("/commands/7?wait=0.1")
    harness.answers = [record("completed")]
    harness.run(harness.protocol.stop())
    assert not harness.protocol.has_endless_motion


def test_a_lost_command_is_sent_again_with_its_key() -> None:
    harness = Harness(LOST, problem(503, "restarting"), record("completed"))
    harness.move()
    keys = [request.headers["Idempotency-Key"] for request in harness.requests]
    assert len(keys) == 3 and len(set(keys)) == 1
    ages = [json.loads(request.body or b"").get("age") for request in harness.requests]
    assert ages == [None, 250, 750]
    other = Harness(record("completed"))
    other.move()
    assert other.requests[0].headers["Idempotency-Key"] != keys[0]


def test_waiting_continues_after_a_network_outage_of_twelve_seconds() -> None:
    harness = Harness(LOST)

    def answer() -> Response:
        return LOST if harness.now < 112 else Response(200, b"{}")

    setattr(harness, "_answer", answer)
    harness.run(harness.protocol.wait(20))
    assert harness.now >= 120


def test_every_request_contains_the_encoded_name() -> None:
    harness = Harness(record("completed"))
    harness.run(harness.protocol.execute(go_forward(100)))
    assert "Script-Name" not in harness.requests[0].headers
    address = parse_address(f"http://robots.example/r/abc#{KEY}")
    protocol = RobotProtocol(address, 30.0, 60.0, name="Größe 5 ✓" + "x" * 400)
    step = next(protocol.check_access())
    assert isinstance(step, Request)
    assert step.headers["Script-Name"].startswith("Gr%C3%B6%C3%9Fe 5 %E2%9C%93xxx")
    assert len(step.headers["Script-Name"]) < 100


def test_a_blocked_script_gets_an_error_without_retries() -> None:
    harness = Harness(problem(403, "blocked", "The robot's owner has blocked this script."))
    with pytest.raises(NotAuthorisedError) as caught:
        harness.run(harness.protocol.execute(go_forward(100)))
    assert "owner has blocked this script" in str(caught.value)
    assert caught.value.code == "blocked"
    assert len(harness.requests) == 1


def test_every_command_contains_the_time_to_live_in_ms() -> None:
    harness = Harness(record("completed"), ttl=0.5)
    harness.move()
    assert json.loads(harness.requests[0].body or b"")["ttl"] == 500


def test_a_stop_has_its_own_time_to_live() -> None:
    harness = Harness(record("completed"), ttl=0.2)
    harness.run(harness.protocol.stop())
    assert "ttl" not in json.loads(harness.requests[0].body or b"")


def times_of(harness: Harness) -> List[List[str]]:
    """The clock and the time of each request."""
    return [request.headers["Script-Clock"].split(" ") for request in harness.requests]


def test_each_attempt_contains_its_send_time_by_one_clock() -> None:
    harness = Harness(LOST, LOST, record("accepted"), 1.5, record("completed"), record("completed"))
    harness.move()
    times = times_of(harness)
    assert [int(at) for _clock, at in times] == [0, 250, 750, 750]
    assert len({clock for clock, _at in times}) == 1 and len(times[0][0]) == 32
    other = Harness(record("completed"))
    other.move()
    assert times_of(other)[0][0] != times[0][0]


def ages_of(harness: Harness) -> List[Optional[int]]:
    sent = [request.body for request in harness.requests if request.method == "POST"]
    return [json.loads(body or b"").get("age") for body in sent]


def test_the_shortest_round_trip_is_added_to_the_age_of_each_command() -> None:
    harness = Harness(record("completed"), latency=3.0, is_checked=False)
    harness.move()
    assert [request.method for request in harness.requests] == ["GET", "POST"]
    harness.latency = 0.05
    harness.move()
    harness.latency = 1.0
    harness.move()
    harness.move()
    assert ages_of(harness) == [3_000, 3_000, 50, 50]


def test_a_long_poll_is_not_measured() -> None:
    harness = Harness(Response(200, b"{}"), latency=0.2, is_checked=False)
    harness.run(harness.protocol.check_access())
    harness.latency = 0.001
    harness.answers = [snapshot(4)]
    harness.run(harness.protocol.next_snapshot())
    harness.answers = [record("completed")]
    harness.move()
    assert ages_of(harness) == [200]


def test_a_command_that_arrived_too_late_is_reported_as_expired() -> None:
    harness = Harness(3.0, problem(422, "too-late", "It is 3000 ms old."), ttl=0.4)
    with pytest.raises(CommandEndedError) as error:
        harness.move()
    assert error.value.code == "expired"
    assert "The command arrived too late and was not executed" in str(error.value)
    assert len(harness.requests) == 1


def test_a_command_that_is_not_too_late_is_retried_then_with_another_clock() -> None:
    late = problem(422, "too-late")
    harness = Harness(late, record("completed"), latency=0.01, ttl=0.4)
    harness.move()
    assert len(harness.requests) == 2
    slept = Harness(late, late, Response(200, b"{}"), record("completed"), latency=0.01, ttl=0.4)
    slept.move()
    assert [request.method for request in slept.requests] == ["POST", "POST", "GET", "POST"]
    (first, _), (second, _), (third, at), (fourth, _) = times_of(slept)
    assert first == second != third == fourth and at == "0"
    hopeless = Harness(late, latency=0.01, ttl=0.4)
    with pytest.raises(CommandEndedError):
        hopeless.move()
    assert len([1 for request in hopeless.requests if request.method == "POST"]) <= 3


def test_a_command_that_expires_too_early_is_sent_again_with_another_key() -> None:
    """The host takes it for older than it is if the round trips before it were longer."""
    expired = record("expired")
    harness = Harness(record("accepted"), expired, record("completed"), latency=0.02, ttl=0.4)
    assert harness.move().state == "completed"
    first, second = [request for request in harness.requests if request.method == "POST"]
    assert first.headers["Idempotency-Key"] != second.headers["Idempotency-Key"]
    assert ages_of(harness) == [None, 40]
    for hopeless in (Harness(expired, latency=0.02, ttl=0.4), Harness(0.5, expired, ttl=0.4)):
        with pytest.raises(CommandEndedError) as error:
            hopeless.move()
        assert error.value.code == "expired"
        assert len(hopeless.requests) <= 2


def test_a_command_that_expires_a_round_trip_too_early_keeps_its_reason() -> None:
    expired = record("expired", "The run is paused.")
    harness = Harness(record("accepted"), 0.38, expired, latency=0.01, ttl=0.4)
    with pytest.raises(CommandEndedError, match="The run is paused"):
        harness.move()
    assert len(harness.requests) == 2


def test_a_command_that_expires_too_early_never_overtakes_a_later_one() -> None:
    harness = Harness(record("completed"), latency=0.02, ttl=0.4)
    move = harness.protocol.execute(go_forward(100))
    next(move)
    harness.move()
    with pytest.raises(CommandEndedError):
        move.send(record("expired"))


def test_random_delays_double_from_a_quarter_second_to_ten() -> None:
    harness = Harness(LOST)
    with pytest.raises(NoAnswerError, match="connection refused"):
        harness.move()
    assert harness.delays == [0.25, 0.5, 1, 2, 4, 8, 10]
    lucky = Harness(LOST, LOST, LOST, record("completed"), rand=0.5)
    lucky.move()
    assert lucky.delays == [0.125, 0.125, 0.25]


def test_many_short_delays_after_a_short_outage_lead_to_no_long_one() -> None:
    harness = Harness(LOST, LOST, LOST, LOST, LOST, LOST, record("completed"), rand=0.1)
    harness.move()
    assert sum(harness.delays) < 0.25
    assert max(harness.delays) < 0.05


def test_retry_after_is_respected() -> None:
    harness = Harness(Response(429, b"{}", retry_after=3.0), record("completed"))
    harness.move()
    assert harness.delays == [3.0]


def test_the_first_request_has_a_shorter_timeout() -> None:
    harness = Harness(LOST)
    with pytest.raises(NoAnswerError, match="the robot is at http://robots.example"):
        harness.run(harness.protocol.check_access())
    assert harness.now <= 110


def test_an_error_names_each_field_once() -> None:
    errors = [{"path": "action", "found": '"fly"', "expected": "one of forward, reverse"}]
    detail = "Invalid command. action: found 'fly', expected one of forward, reverse."
    harness = Harness(problem(400, "bad-request", detail, errors=errors))
    with pytest.raises(CommandError) as error:
        harness.move()
    assert str(error.value).count("expected one of forward") == 1


def test_an_error_names_the_invalid_field_and_the_expected_value() -> None:
    errors = [{"path": "distance", "found": "text", "expected": "a distance in cm"}]
    harness = Harness(problem(400, "bad-request", "Invalid command.", errors=errors))
    with pytest.raises(CommandError) as error:
        harness.move()
    assert error.value.code == "refused"
    assert "Invalid command. distance: found text, expected a distance in cm." in str(error.value)
    assert len(harness.requests) == 1


@pytest.mark.parametrize(
    ("answer", "kind", "code"),
    [
        (problem(401, "not-authorised"), NotAuthorisedError, "not-authorised"),
        (problem(403, "forbidden"), NotAuthorisedError, "not-authorised"),
        (problem(404, "no-robot"), RobotGoneError, "no-robot"),
        (problem(410, "over"), RobotGoneError, "no-robot"),
        (problem(409, "no-snapshot"), RobotGoneError, "robot-gone"),
        (problem(409, "key-conflict"), CommandError, "refused"),
        (problem(404, "no-command"), CommandError, "refused"),
        (Response(407, b"<html>"), Exception, "refused"),
        (Response(302), AddressError, "bad-address"),
        (Response(200, b"<html>sign in</html>"), AddressError, "bad-address"),
        (Response(200, b"[]"), AddressError, "bad-address"),
        (Response(0, error="self-signed", is_untrusted=True), AddressError, "bad-address"),
    ],
)
def test_permanent_failures_are_not_retried(answer: Response, kind: Any, code: str) -> None:
    harness = Harness(answer)
    with pytest.raises(kind) as error:
        harness.move()
    assert error.value.code == code
    assert error.value.hint.endswith((".", ".)"))
    assert KEY not in str(error.value)
    assert len(harness.requests) == 1


@pytest.mark.parametrize("state", ["cancelled", "superseded", "expired"])
def test_a_command_that_ended_early_is_an_error_with_its_reason(state: str) -> None:
    harness = Harness(record("accepted"), record(state, "the robot was switched off"))
    with pytest.raises(CommandEndedError, match="The robot was switched off.") as error:
        harness.move()
    assert error.value.code == state
    assert str(error.value).count(state) == 1


CLOSED = "The robot's page is closed or offline: open it again and choose Remote."


def test_the_reason_why_a_command_does_not_continue_is_printed_once(
    caplog: pytest.LogCaptureFixture,
) -> None:
    silent: List[Union[Response, float]] = [1.5, record("started", CLOSED)] * 20
    Harness(record("accepted"), *silent, record("completed")).move()
    assert caplog.messages == [CLOSED]


def test_the_reason_is_printed_again_only_after_the_command_has_continued(
    caplog: pytest.LogCaptureFixture,
) -> None:
    silent: List[Union[Response, float]] = [1.5, record("started", CLOSED)] * 2
    Harness(record("started"), *silent, 1.5, record("started"), *silent, record("completed")).move()
    assert caplog.messages == [CLOSED, CLOSED]


def test_a_command_that_continues_within_3_seconds_prints_nothing(
    caplog: pytest.LogCaptureFixture,
) -> None:
    Harness(
        record("started"), 1.5, record("started", CLOSED), 1.5, record("started"), record("completed")
    ).move()
    assert caplog.messages == []


def test_a_host_that_does_not_respond_is_named_once(caplog: pytest.LogCaptureFixture) -> None:
    Harness(LOST, LOST, LOST, LOST, record("completed")).move()
    assert caplog.messages == [
        "The robot's host does not respond at http://robots.example (connection refused). Retrying."
    ]


def test_a_wrong_id_is_named_with_what_to_check() -> None:
    detail = "Check the id for typing errors, or copy the address again."
    harness = Harness(problem(404, "no-robot", detail))
    with pytest.raises(RobotGoneError) as error:
        harness.move()
    assert str(error.value) == (
        "No robot has the id abc (no-robot). Check the id for typing errors, or copy the address again."
    )


def test_a_command_by_a_watch_link_reports_what_the_link_is_for() -> None:
    protocol = RobotProtocol(
        parse_address(f"http://robots.example/r/abc#wch_{KEY[4:]}"), 30.0, 60.0, rand=lambda: 1.0
    )
    harness = Harness(problem(403, "forbidden", "A watch key permits only reading."))
    with pytest.raises(NotAuthorisedError, match="This is a watch link: it can only read") as error:
        harness.run(protocol.execute(go_forward(100)))
    assert "Copy address with key" in error.value.hint


def test_replacing_an_endless_motion_is_not_an_error() -> None:
    harness = Harness(record("superseded"))
    assert harness.run(harness.protocol.execute(go_forward(None))).state == "superseded"


def test_a_robot_that_does_not_finish_is_reported_after_the_timeout() -> None:
    harness = Harness(record("accepted"), 25.0, record("started"), 45.0, record("started"))
    with pytest.raises(NoAnswerError, match="did not finish command 7"):
        harness.move()


def test_each_reading_requests_a_newer_snapshot() -> None:
    harness = Harness(snapshot(4), snapshot(6))
    assert harness.run(harness.protocol.next_snapshot()).seq == 4
    assert harness.run(harness.protocol.next_snapshot()).seq == 6
    assert [request.url.split("/abc")[1] for request in harness.requests] == [
        "/sensors?wait=10",
        "/sensors?after=4&wait=0.05",
    ]


def test_the_last_snapshot_of_a_closed_page_is_not_returned_as_new() -> None:
    back = Harness(snapshot(4, state="gone"), 1.0, snapshot(4, state="gone"), snapshot(1))
    assert back.run(back.protocol.next_snapshot()).state == "running"
    away = Harness(31.0, snapshot(4, state="gone"))
    with pytest.raises(RobotGoneError, match="page is closed or not connected.*press Connect") as error:
        away.run(away.protocol.next_snapshot())
    assert error.value.code == "robot-gone"


def test_wait_until_ends_with_the_condition_or_the_timeout() -> None:
    near: Any = lambda sensor: sensor.front < 60  # noqa: E731
    harness = Harness(snapshot(1, front=250), snapshot(2, front=70), snapshot(3, front=50))
    assert harness.run(harness.protocol.wait_until(near, 5)) == Sensors(50, 50, 50, 50)
    late = Harness(snapshot(1, front=250), latency=1.0)
    with pytest.raises(NoAnswerError, match="front=250"):
        late.run(late.protocol.wait_until(near, 5))


def test_wait_sends_requests_more_often_than_the_robot_requires() -> None:
    harness = Harness(Response(200, b'{"commands": []}'))
    harness.run(harness.protocol.wait(2.5))
    assert harness.delays == [1, 1, 0.5]
    assert len(harness.requests) == 3


def test_all_pages_of_the_log_are_read() -> None:
    def page(first: int, count: int) -> Response:
        records = [json.loads(record("completed", seq=first + n).body) for n in range(count)]
        return Response(200, json.dumps({"commands": records}).encode())

    harness = Harness(page(1, 200), page(201, 3))
    assert [command.seq for command in harness.run(harness.protocol.log())] == list(range(1, 204))
    assert harness.requests[1].url.endswith("/commands?after=200")


def test_a_closed_robot_sends_no_requests() -> None:
    harness = Harness(record("completed"))
    harness.protocol.is_closed = True
    with pytest.raises(ClosedError):
        harness.move()
    assert harness.requests == []


def test_the_key_is_in_a_header_and_never_in_a_url() -> None:
    harness = Harness(record("accepted"), record("completed"), snapshot(1))
    harness.move()
    harness.run(harness.protocol.next_snapshot())
    for request in harness.requests:
        assert request.headers["Authorization"] == f"Bearer {KEY}"
        assert KEY not in request.url
