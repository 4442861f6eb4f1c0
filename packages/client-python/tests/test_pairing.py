"""A code in place of an address: by itself, and at the real relay."""

import asyncio
import json
import threading
import urllib.request
from typing import Any, Iterator, List, Optional, Tuple

import pytest
from conftest import Host
from corridor import AddressError, AsyncRobot, NoAnswerError, PairingError, Robot, RobotError
from corridor import pairing
from corridor.requests import Answer, Pause, Request

ADDRESS = "http://host/r/AAAAAAAAAAAAAAAAAAAAAA#drv_AAAAAAAAAAAAAAAAAAAAAA"
ASKED = Answer(202, json.dumps({"key": "drv_new", "endsInSeconds": 60}).encode())
LOST = Answer(0, lost="connection refused")


@pytest.fixture(autouse=True)
def no_wrong_codes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pairing._Tries, "wrong", 0)


def problem(status: int, kind: str) -> Answer:
    document = {"type": f"/problems/{kind}", "title": "No", "status": status, "detail": "So."}
    return Answer(status, json.dumps({**document, "errors": []}).encode())


def said(address: Optional[str]) -> Answer:
    state = "asked" if address is None else "accepted"
    return Answer(200, json.dumps({"state": state, "address": address, "endsInSeconds": 9}).encode())


def talk(*answers: Answer, code: str = "bcdf-ghjk") -> Tuple[str, List[Request]]:
    """What comes of a talk with these answers; each takes 20 seconds."""
    now, rest, requests = [0.0], list(answers), []
    steps = pairing.pair("http://host/x", code, "Me", 30.0, lambda: now[0], lambda: 1.0)
    try:
        step = next(steps)
        while True:
            if isinstance(step, Pause):
                step = steps.send(None)
            else:
                requests.append(step)
                now[0] += 20
                step = steps.send(rest.pop(0) if len(rest) > 1 else rest[0])
    except StopIteration as end:
        return str(end.value), requests


def test_the_code_is_asked_with_and_the_answer_waited_for() -> None:
    address, requests = talk(ASKED, said(None), said(ADDRESS))
    assert address == ADDRESS
    assert [request.url for request in requests] == [
        "http://host/api/v1/pairing",
        "http://host/api/v1/pairing?wait=10",
        "http://host/api/v1/pairing?wait=10",
    ]
    assert json.loads(requests[0].body or b"") == {"code": "BCDFGHJK", "name": "Me"}
    assert requests[1].headers["Authorization"] == "Bearer drv_new"
    assert talk(LOST, ASKED, LOST, said(ADDRESS))[0] == ADDRESS
    # Beside the wrong codes of others, this one was not checked yet.
    assert talk(problem(429, "too-fast"), ASKED, said(ADDRESS))[0] == ADDRESS


def test_a_script_that_waits_for_the_owner_says_so(caplog: pytest.LogCaptureFixture) -> None:
    talk(ASKED, said(None), said(ADDRESS))
    assert caplog.messages == ["Waiting for 'Yes, let it drive' on the robot's page."]


@pytest.mark.parametrize(
    ("answers", "code"),
    [
        ([problem(404, "no-pairing")], "wrong-code"),
        ([problem(409, "code-used")], "wrong-code"),
        ([problem(429, "too-fast")], "too-many-tries"),
        ([ASKED, problem(403, "pairing-refused")], "pairing-refused"),
        ([ASKED, problem(404, "no-pairing")], "pairing-over"),
        ([ASKED, said(None)], "pairing-over"),
    ],
)
def test_each_way_to_fail_has_a_code(answers: List[Answer], code: str) -> None:
    with pytest.raises(PairingError) as error:
        talk(*answers)
    assert error.value.code == code
    assert "BCDFGHJK" not in str(error.value) and "drv_" not in str(error.value)


def test_a_wrong_place_is_no_wrong_code() -> None:
    with pytest.raises(AddressError):
        talk(Answer(404, b"<html>"))
    with pytest.raises(AddressError):
        Robot.pair("host", "BCDF GHJK")
    with pytest.raises(NoAnswerError):
        talk(LOST)


def test_ten_wrong_codes_are_enough() -> None:
    for code in ["BCDF", "AAAAAAAA"]:
        with pytest.raises(PairingError, match="8 letters"):
            talk(ASKED, code=code)
    for _ in range(8):
        with pytest.raises(PairingError, match="wrong-code"):
            talk(problem(404, "no-pairing"))
    with pytest.raises(PairingError, match="too-many-tries"):
        talk(ASKED, said(ADDRESS))


class Owner:
    """The owner's side, as the page has it."""

    def __init__(self, host: Host) -> None:
        robot = host.address.split("/r/")[1].split("#")[0]
        self._url = f"{host.origin}/api/v1/robots/{robot}/pairing"
        self._key = host.owner_key

    def ask(self, method: str, query: str = "", body: Any = None) -> Any:
        headers = {"Authorization": f"Bearer {self._key}", "Content-Type": "application/json"}
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self._url + query, data, headers, method=method)
        with urllib.request.urlopen(request) as answer:
            return json.loads(answer.read() or b"null")

    def answer_later(self, accept: bool) -> threading.Thread:
        def answer() -> None:
            question = self.ask("GET", "?wait=20")["question"]
            self.ask("PUT", body={"id": question["id"], "accept": accept})

        thread = threading.Thread(target=answer)
        thread.start()
        return thread


@pytest.fixture
def owner(corridor: Host) -> Iterator[Owner]:
    yield Owner(corridor)


def test_a_script_drives_after_a_yes_with_a_key_of_its_own(corridor: Host, owner: Owner) -> None:
    code = owner.ask("POST")["code"]
    answered = owner.answer_later(True)
    robot = Robot.pair(corridor.origin, code, name="Paired")
    answered.join()
    assert robot.right(90).state == "completed"
    assert robot.address.startswith(f"{corridor.origin}/r/") and robot.address != corridor.address
    assert Robot(robot.address).forward(100).distance == 100
    assert "drv_" not in repr(robot)


def test_a_script_is_told_of_a_no(corridor: Host, owner: Owner) -> None:
    code = owner.ask("POST")["code"]
    answered = owner.answer_later(False)
    with pytest.raises(PairingError, match="pairing-refused"):
        Robot.pair(corridor.origin, code)
    answered.join()
    with pytest.raises(PairingError, match="wrong-code"):
        Robot.pair(corridor.origin, code)


def test_the_same_with_asyncio(corridor: Host, owner: Owner) -> None:
    async def drive() -> str:
        code = owner.ask("POST")["code"]
        answered = owner.answer_later(True)
        robot = await AsyncRobot.pair(corridor.origin, code)
        answered.join()
        assert robot.address != corridor.address
        return (await robot.right(90)).state

    assert asyncio.run(drive()) == "completed"
    with pytest.raises(RobotError):
        asyncio.run(AsyncRobot.pair(corridor.origin, "BCDF GHJK"))
