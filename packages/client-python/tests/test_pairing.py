"""Pairing with prepared responses, and with a real relay."""

import asyncio
import json
import threading
import urllib.request
from typing import Any, Iterator, List, Optional, Tuple

import pytest
from conftest import Host
from corridor import AddressError, AsyncRobot, NoAnswerError, PairingError, Robot, RobotError
from corridor import pairing
from corridor.requests import Response, Delay, Request

ADDRESS = "http://host/r/AAAAAAAAAAAAAAAAAAAAAA#drv_AAAAAAAAAAAAAAAAAAAAAA"
REQUESTED = Response(202, json.dumps({"key": "drv_new", "endsInSeconds": 60}).encode())
LOST = Response(0, error="connection refused")


@pytest.fixture(autouse=True)
def no_wrong_codes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pairing._Attempts, "wrong", 0)


def problem(status: int, kind: str) -> Response:
    document = {"type": f"/problems/{kind}", "title": "No", "status": status, "detail": "So."}
    return Response(status, json.dumps({**document, "errors": []}).encode())


def answered(address: Optional[str]) -> Response:
    state = "asked" if address is None else "accepted"
    return Response(200, json.dumps({"state": state, "address": address, "endsInSeconds": 9}).encode())


def run_pairing(*answers: Response, code: str = "bcdf-ghjk") -> Tuple[str, List[Request]]:
    """The result of pairing with these responses; each takes 20 seconds."""
    now, rest, requests = [0.0], list(answers), []
    steps = pairing.pair("http://host/x", code, "Me", 30.0, lambda: now[0], lambda: 1.0)
    try:
        step = next(steps)
        while True:
            if isinstance(step, Delay):
                step = steps.send(None)
            else:
                requests.append(step)
                now[0] += 20
                step = steps.send(rest.pop(0) if len(rest) > 1 else rest[0])
    except StopIteration as end:
        return str(end.value), requests


def test_a_script_sends_the_code_and_waits_for_the_answer() -> None:
    address, requests = run_pairing(REQUESTED, answered(None), answered(ADDRESS))
    assert address == ADDRESS
    assert [request.url for request in requests] == [
        "http://host/api/v1/pairing",
        "http://host/api/v1/pairing?wait=10",
        "http://host/api/v1/pairing?wait=10",
    ]
    assert json.loads(requests[0].body or b"") == {"code": "BCDFGHJK", "name": "Me"}
    assert requests[1].headers["Authorization"] == "Bearer drv_new"
    assert run_pairing(LOST, REQUESTED, LOST, answered(ADDRESS))[0] == ADDRESS
    # The service has not checked this code yet, because of other wrong ones.
    assert run_pairing(problem(429, "too-fast"), REQUESTED, answered(ADDRESS))[0] == ADDRESS


def test_a_script_that_waits_for_the_owner_logs_it(caplog: pytest.LogCaptureFixture) -> None:
    run_pairing(REQUESTED, answered(None), answered(ADDRESS))
    assert caplog.messages == ["Waiting for 'Yes, let it drive' on the robot's page."]


@pytest.mark.parametrize(
    ("answers", "code"),
    [
        ([problem(404, "no-pairing")], "wrong-code"),
        ([problem(409, "code-used")], "wrong-code"),
        ([problem(429, "too-fast")], "too-many-tries"),
        ([REQUESTED, problem(403, "pairing-refused")], "pairing-refused"),
        ([REQUESTED, problem(404, "no-pairing")], "pairing-over"),
        ([REQUESTED, answered(None)], "pairing-over"),
    ],
)
def test_each_failure_has_a_code(answers: List[Response], code: str) -> None:
    with pytest.raises(PairingError) as error:
        run_pairing(*answers)
    assert error.value.code == code
    assert "BCDFGHJK" not in str(error.value) and "drv_" not in str(error.value)


def test_a_wrong_service_is_not_a_wrong_code() -> None:
    with pytest.raises(AddressError):
        run_pairing(Response(404, b"<html>"))
    with pytest.raises(AddressError):
        Robot.pair("host", "BCDF GHJK")
    with pytest.raises(NoAnswerError):
        run_pairing(LOST)


def test_ten_wrong_codes_are_the_maximum() -> None:
    for code in ["BCDF", "AAAAAAAA"]:
        with pytest.raises(PairingError, match="8 letters"):
            run_pairing(REQUESTED, code=code)
    for _ in range(8):
        with pytest.raises(PairingError, match="wrong-code"):
            run_pairing(problem(404, "no-pairing"))
    with pytest.raises(PairingError, match="too-many-tries"):
        run_pairing(REQUESTED, answered(ADDRESS))


class Owner:
    """The requests of the owner's page."""

    def __init__(self, host: Host) -> None:
        robot = host.address.split("/r/")[1].split("#")[0]
        self._url = f"{host.origin}/api/v1/robots/{robot}/pairing"
        self._key = host.owner_key

    def request(self, method: str, query: str = "", body: Any = None) -> Any:
        headers = {"Authorization": f"Bearer {self._key}", "Content-Type": "application/json"}
        data = None if body is None else json.dumps(body).encode()
        prepared = urllib.request.Request(self._url + query, data, headers, method=method)
        with urllib.request.urlopen(prepared) as answer:
            return json.loads(answer.read() or b"null")

    def answer_later(self, accept: bool) -> threading.Thread:
        def answer() -> None:
            question = self.request("GET", "?wait=20")["question"]
            self.request("PUT", body={"id": question["id"], "accept": accept})

        thread = threading.Thread(target=answer)
        thread.start()
        return thread


@pytest.fixture
def owner(corridor: Host) -> Iterator[Owner]:
    yield Owner(corridor)


def test_an_accepted_script_drives_with_its_own_key(corridor: Host, owner: Owner) -> None:
    code = owner.request("POST")["code"]
    answered = owner.answer_later(True)
    robot = Robot.pair(corridor.origin, code, name="Paired")
    answered.join()
    assert robot.right(90).state == "completed"
    assert robot.address.startswith(f"{corridor.origin}/r/") and robot.address != corridor.address
    assert Robot(robot.address).forward(100).distance == 100
    assert "drv_" not in repr(robot)


def test_a_refused_script_gets_an_error(corridor: Host, owner: Owner) -> None:
    code = owner.request("POST")["code"]
    answered = owner.answer_later(False)
    with pytest.raises(PairingError, match="pairing-refused"):
        Robot.pair(corridor.origin, code)
    answered.join()
    with pytest.raises(PairingError, match="wrong-code"):
        Robot.pair(corridor.origin, code)


def test_pairing_with_asyncio(corridor: Host, owner: Owner) -> None:
    async def drive() -> str:
        code = owner.request("POST")["code"]
        answered = owner.answer_later(True)
        robot = await AsyncRobot.pair(corridor.origin, code)
        answered.join()
        assert robot.address != corridor.address
        return (await robot.right(90)).state

    assert asyncio.run(drive()) == "completed"
    with pytest.raises(RobotError):
        asyncio.run(AsyncRobot.pair(corridor.origin, "BCDF GHJK"))
