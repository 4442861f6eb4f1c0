"""Tries, keys, pauses and errors, with a clock that only the test moves and no line at all."""

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
from corridor.requests import Answer, Pause, Request, T, Talk
from corridor.protocol import RobotTalk

KEY = "drv_AAAAAAAAAAAAAAAAAAAAAA"
LOST = Answer(0, lost="connection refused")


def record(state: str, reason: Optional[str] = None, seq: int = 7) -> Answer:
    return Answer(
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
) -> Answer:
    sensors = {"front": front, "right": right, "back": 50, "left": 50}
    pose = {"x": 50, "y": 50, "heading": 0}
    seen = {"seq": seq, "tick": seq, "state": state, "driver": "remote", "sensors": sensors}
    rest = {"motion": "stop", "bumps": 0, "bumping": False, "goalReached": False, "command": None}
    return Answer(200, json.dumps({**seen, "pose": pose, **rest, "line": None}).encode())


def problem(status: int, kind: str, detail: str = "Mend it so.", **more: Any) -> Answer:
    document = {"type": f"/problems/{kind}", "title": "No", "status": status, "detail": detail}
    return Answer(status, json.dumps({**document, "errors": [], **more}).encode())


class Scene:
    """A talk, the answers that it gets in turn, and what it asked for and waited."""

    def __init__(
        self,
        *answers: Union[Answer, float],
        chance: float = 1.0,
        latency: float = 0.0,
        ttl: Optional[float] = None,
        greeted: bool = True,
    ) -> None:
        self.now = 100.0
        self.latency = 0.0
        #: an answer, or how many seconds go by before the next one
        self.answers = list(answers)
        self.requests: List[Request] = []
        self.pauses: List[float] = []
        address = parse_address(f"http://robots.example/r/abc#{KEY}")
        self.talk = RobotTalk(
            address, 30.0, 60.0, ttl, clock=lambda: self.now, chance=lambda: chance
        )
        if greeted:
            self.answers = [Answer(200, b"{}")]
            self.run(self.talk.greet())
            self.answers, self.requests = list(answers), []
        self.latency = latency

    def run(self, talk: Talk[T]) -> T:
        try:
            step = next(talk)
            while True:
                if isinstance(step, Pause):
                    self.pauses.append(step.seconds)
                    self.now += step.seconds
                    step = talk.send(None)
                else:
                    self.requests.append(step)
                    step = talk.send(self._answer())
        except StopIteration as end:
            result: T = end.value
            return result

    def _answer(self) -> Answer:
        self.now += self.latency
        answer = self.answers.pop(0) if len(self.answers) > 1 else self.answers[0]
        while isinstance(answer, float):
            self.now += answer
            answer = self.answers.pop(0) if len(self.answers) > 1 else self.answers[0]
        return answer

    def move(self) -> Command:
        return self.run(self.talk.do(go_forward(100)))


def test_a_move_waits_until_the_robot_has_finished_it() -> None:
    scene = Scene(record("accepted"), record("started"), record("completed"))
    command = scene.move()
    assert command.state == "completed" and command.distance == 100 and command
    assert [request.url.split("/abc")[1] for request in scene.requests] == [
        "/commands",
        "/commands/7?wait=10",
        "/commands/7?wait=10",
    ]
    assert json.loads(scene.requests[0].body or b"") == {"action": "move", "distance": 100}


def test_a_wall_in_the_way_is_an_outcome_not_an_error() -> None:
    command = Scene(record("collided")).move()
    assert command.collided
    assert not command


def test_a_motion_without_an_end_waits_until_it_has_begun() -> None:
    scene = Scene(record("accepted"), record("delivered"), record("started"))
    assert scene.run(scene.talk.do(go_forward(None))).state == "started"
    assert scene.talk.drives_on
    assert scene.requests[1].url.endswith("/commands/7?wait=0.1")
    scene.answers = [record("completed")]
    scene.run(scene.talk.stop())
    assert not scene.talk.drives_on


def test_a_lost_command_is_sent_again_with_its_key() -> None:
    scene = Scene(LOST, problem(503, "restarting"), record("completed"))
    scene.move()
    keys = [request.headers["Idempotency-Key"] for request in scene.requests]
    assert len(keys) == 3 and len(set(keys)) == 1
    ages = [json.loads(request.body or b"").get("age") for request in scene.requests]
    assert ages == [None, 250, 750]
    other = Scene(record("completed"))
    other.move()
    assert other.requests[0].headers["Idempotency-Key"] != keys[0]


def test_a_name_goes_with_every_request_in_letters_that_a_header_can_hold() -> None:
    scene = Scene(record("completed"))
    scene.run(scene.talk.do(go_forward(100)))
    assert "Script-Name" not in scene.requests[0].headers
    address = parse_address(f"http://robots.example/r/abc#{KEY}")
    talk = RobotTalk(address, 30.0, 60.0, name="Größe 5 ✓" + "x" * 400)
    step = next(talk.greet())
    assert isinstance(step, Request)
    assert step.headers["Script-Name"].startswith("Gr%C3%B6%C3%9Fe 5 %E2%9C%93xxx")
    assert len(step.headers["Script-Name"]) < 100


def test_a_script_that_was_blocked_reads_so_and_does_not_try_again() -> None:
    scene = Scene(problem(403, "blocked", "The robot's owner has sent this script away."))
    with pytest.raises(NotAuthorisedError) as caught:
        scene.run(scene.talk.do(go_forward(100)))
    assert "owner has sent this script away" in str(caught.value)
    assert caught.value.code == "blocked"
    assert len(scene.requests) == 1


def test_a_time_to_live_goes_with_every_command_in_ms() -> None:
    scene = Scene(record("completed"), ttl=0.5)
    scene.move()
    assert json.loads(scene.requests[0].body or b"")["ttl"] == 500


def test_a_stop_keeps_its_own_time_to_live() -> None:
    scene = Scene(record("completed"), ttl=0.2)
    scene.run(scene.talk.stop())
    assert "ttl" not in json.loads(scene.requests[0].body or b"")


def times_of(scene: Scene) -> List[List[str]]:
    """The clock and the time of each request."""
    return [request.headers["Script-Clock"].split(" ") for request in scene.requests]


def test_each_try_says_by_one_clock_when_it_is_sent() -> None:
    scene = Scene(LOST, LOST, record("accepted"), 1.5, record("completed"), record("completed"))
    scene.move()
    times = times_of(scene)
    assert [int(at) for _clock, at in times] == [0, 250, 750, 750]
    assert len({clock for clock, _at in times}) == 1 and len(times[0][0]) == 32
    other = Scene(record("completed"))
    other.move()
    assert times_of(other)[0][0] != times[0][0]


def ages_of(scene: Scene) -> List[Optional[int]]:
    sent = [request.body for request in scene.requests if request.method == "POST"]
    return [json.loads(body or b"").get("age") for body in sent]


def test_the_smallest_round_trip_is_added_to_the_age_of_each_command() -> None:
    scene = Scene(record("completed"), latency=3.0, greeted=False)
    scene.move()
    assert [request.method for request in scene.requests] == ["GET", "POST"]
    scene.latency = 0.05
    scene.move()
    scene.latency = 1.0
    scene.move()
    scene.move()
    assert ages_of(scene) == [3_000, 3_000, 50, 50]


def test_a_long_poll_shows_no_round_trip() -> None:
    scene = Scene(Answer(200, b"{}"), latency=0.2, greeted=False)
    scene.run(scene.talk.greet())
    scene.latency = 0.001
    scene.answers = [snapshot(4)]
    scene.run(scene.talk.look())
    scene.answers = [record("completed")]
    scene.move()
    assert ages_of(scene) == [200]


def test_a_command_that_came_too_late_reads_so_in_plain_words() -> None:
    scene = Scene(3.0, problem(422, "too-late", "It is 3000 ms old."), ttl=0.4)
    with pytest.raises(CommandEndedError) as error:
        scene.move()
    assert error.value.code == "expired"
    assert "The command came too late, so the robot did not do it" in str(error.value)
    assert len(scene.requests) == 1


def test_a_command_that_is_not_too_late_is_tried_again_then_by_another_clock() -> None:
    late = problem(422, "too-late")
    scene = Scene(late, record("completed"), latency=0.01, ttl=0.4)
    scene.move()
    assert len(scene.requests) == 2
    slept = Scene(late, late, Answer(200, b"{}"), record("completed"), latency=0.01, ttl=0.4)
    slept.move()
    assert [request.method for request in slept.requests] == ["POST", "POST", "GET", "POST"]
    (first, _), (second, _), (third, at), (fourth, _) = times_of(slept)
    assert first == second != third == fourth and at == "0"
    hopeless = Scene(late, latency=0.01, ttl=0.4)
    with pytest.raises(CommandEndedError):
        hopeless.move()
    assert len([1 for request in hopeless.requests if request.method == "POST"]) <= 3


def test_the_pauses_double_from_a_quarter_second_to_ten_and_are_drawn_by_lot() -> None:
    scene = Scene(LOST)
    with pytest.raises(NoAnswerError, match="connection refused"):
        scene.move()
    assert scene.pauses == [0.25, 0.5, 1, 2, 4, 8, 10]
    lucky = Scene(LOST, LOST, LOST, record("completed"), chance=0.5)
    lucky.move()
    assert lucky.pauses == [0.125, 0.125, 0.25]


def test_many_short_pauses_after_a_short_cut_lead_to_no_long_one() -> None:
    scene = Scene(LOST, LOST, LOST, LOST, LOST, LOST, record("completed"), chance=0.1)
    scene.move()
    assert sum(scene.pauses) < 0.25
    assert max(scene.pauses) < 0.05


def test_a_host_that_says_when_to_come_back_is_taken_at_its_word() -> None:
    scene = Scene(Answer(429, b"{}", retry_after=3.0), record("completed"))
    scene.move()
    assert scene.pauses == [3.0]


def test_a_host_that_was_never_heard_is_given_up_sooner() -> None:
    scene = Scene(LOST)
    with pytest.raises(NoAnswerError, match="http://robots.example is where the robot is"):
        scene.run(scene.talk.greet())
    assert scene.now <= 110


def test_a_refusal_says_a_field_once_that_its_detail_names() -> None:
    errors = [{"path": "action", "found": '"fly"', "expected": "one of forward, reverse"}]
    detail = "The command is wrong. action: found 'fly', expected one of forward, reverse."
    scene = Scene(problem(400, "bad-request", detail, errors=errors))
    with pytest.raises(CommandError) as error:
        scene.move()
    assert str(error.value).count("expected one of forward") == 1


def test_a_refusal_says_which_field_is_wrong_and_what_was_expected() -> None:
    errors = [{"path": "distance", "found": "text", "expected": "a distance in cm"}]
    scene = Scene(problem(400, "bad-request", "The command is wrong.", errors=errors))
    with pytest.raises(CommandError) as error:
        scene.move()
    assert error.value.code == "refused"
    assert "The command is wrong. distance: found text, expected a distance in cm." in str(error.value)
    assert len(scene.requests) == 1


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
        (Answer(407, b"<html>"), Exception, "refused"),
        (Answer(302), AddressError, "bad-address"),
        (Answer(200, b"<html>sign in</html>"), AddressError, "bad-address"),
        (Answer(200, b"[]"), AddressError, "bad-address"),
        (Answer(0, lost="self-signed", is_untrusted=True), AddressError, "bad-address"),
    ],
)
def test_what_no_retry_mends_is_told_at_once(answer: Answer, kind: Any, code: str) -> None:
    scene = Scene(answer)
    with pytest.raises(kind) as error:
        scene.move()
    assert error.value.code == code
    assert error.value.hint.endswith((".", ".)"))
    assert KEY not in str(error.value)
    assert len(scene.requests) == 1


@pytest.mark.parametrize("state", ["cancelled", "superseded", "expired"])
def test_a_command_that_was_taken_away_is_an_error_with_its_reason(state: str) -> None:
    scene = Scene(record("accepted"), record(state, "the page was reloaded"))
    with pytest.raises(CommandEndedError, match="The page was reloaded.") as error:
        scene.move()
    assert error.value.code == state
    assert str(error.value).count(state) == 1


def test_another_command_after_a_motion_without_an_end_is_no_error() -> None:
    scene = Scene(record("superseded"))
    assert scene.run(scene.talk.do(go_forward(None))).state == "superseded"


def test_a_robot_that_does_not_finish_is_told_after_the_time_for_it() -> None:
    scene = Scene(record("accepted"), 25.0, record("started"), 45.0, record("started"))
    with pytest.raises(NoAnswerError, match="does not finish command 7"):
        scene.move()


def test_each_reading_asks_for_a_newer_one() -> None:
    scene = Scene(snapshot(4), snapshot(6))
    assert scene.run(scene.talk.look()).seq == 4
    assert scene.run(scene.talk.look()).seq == 6
    assert [request.url.split("/abc")[1] for request in scene.requests] == [
        "/sensors?wait=10",
        "/sensors?after=4&wait=0.05",
    ]


def test_readings_of_a_robot_whose_page_is_away_are_not_passed_off_as_new() -> None:
    back = Scene(snapshot(4, state="gone"), 1.0, snapshot(4, state="gone"), snapshot(1))
    assert back.run(back.talk.look()).state == "running"
    away = Scene(31.0, snapshot(4, state="gone"))
    with pytest.raises(RobotGoneError, match="page is closed or not connected.*press Connect") as error:
        away.run(away.talk.look())
    assert error.value.code == "robot-gone"


def test_waiting_for_a_reading_ends_with_it_or_with_the_time() -> None:
    near: Any = lambda sensor: sensor.front < 60  # noqa: E731
    scene = Scene(snapshot(1, front=250), snapshot(2, front=70), snapshot(3, front=50))
    assert scene.run(scene.talk.wait_until(near, 5)) == Sensors(50, 50, 50, 50)
    late = Scene(snapshot(1, front=250), latency=1.0)
    with pytest.raises(NoAnswerError, match="front=250"):
        late.run(late.talk.wait_until(near, 5))


def test_a_script_that_waits_gives_signs_of_life_more_often_than_the_lease_runs_out() -> None:
    scene = Scene(Answer(200, b'{"commands": []}'))
    scene.run(scene.talk.wait(2.5))
    assert scene.pauses == [1, 1, 0.5]
    assert len(scene.requests) == 3


def test_the_log_is_read_to_its_end() -> None:
    def page(first: int, count: int) -> Answer:
        records = [json.loads(record("completed", seq=first + n).body) for n in range(count)]
        return Answer(200, json.dumps({"commands": records}).encode())

    scene = Scene(page(1, 200), page(201, 3))
    assert [command.seq for command in scene.run(scene.talk.log())] == list(range(1, 204))
    assert scene.requests[1].url.endswith("/commands?after=200")


def test_a_closed_robot_asks_for_nothing_more() -> None:
    scene = Scene(record("completed"))
    scene.talk.is_closed = True
    with pytest.raises(ClosedError):
        scene.move()
    assert scene.requests == []


def test_the_key_is_in_a_header_and_in_no_address() -> None:
    scene = Scene(record("accepted"), record("completed"), snapshot(1))
    scene.move()
    scene.run(scene.talk.look())
    for request in scene.requests:
        assert request.headers["Authorization"] == f"Bearer {KEY}"
        assert KEY not in request.url
