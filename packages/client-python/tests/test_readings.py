"""Which snapshot a reading is of: one for the readings of one decision."""

import json
from typing import Any, List

from corridor.actions import go_forward
from corridor.reports import Event
from corridor.requests import Answer
from test_protocol import Scene, record, snapshot


def read(scene: Scene, side: str) -> float:
    found: float = getattr(scene.run(scene.talk.read(side)).sensors, side)
    return found


def moving(count: int = 9) -> List[Any]:
    """Snapshots of a robot that drives: each has other readings."""
    return [snapshot(seq, front=1_000 - 10 * seq, right=seq) for seq in range(1, count)]


def test_different_sides_in_one_decision_are_of_one_snapshot() -> None:
    scene = Scene(*moving())
    assert [read(scene, "right"), read(scene, "front")] == [1, 990]
    assert len(scene.requests) == 1


def test_a_side_that_is_read_again_begins_a_new_decision() -> None:
    scene = Scene(*moving())
    pairs = [(read(scene, "right"), read(scene, "front")) for _ in range(3)]
    assert pairs == [(1, 990), (2, 980), (3, 970)]
    # As in `if right > 60 and front < 60`, where the second is not always asked for.
    assert [read(scene, "right"), read(scene, "right"), read(scene, "front")] == [4, 5, 950]


def test_a_decision_ends_after_a_tenth_of_a_second() -> None:
    scene = Scene(*moving())
    read(scene, "right")
    scene.now += 0.09
    assert read(scene, "front") == 990
    scene.now += 0.02
    assert read(scene, "left") == 50 and len(scene.requests) == 2


def test_a_command_ends_a_decision() -> None:
    scene = Scene(snapshot(1, front=150), record("completed"), snapshot(9, front=50))
    read(scene, "right")
    scene.run(scene.talk.do(go_forward(100)))
    assert read(scene, "front") == 50


def page(n: int, *states: Answer, seq: int, gap: bool = False) -> Answer:
    records = [{"n": n, "record": json.loads(state.body)} for state in states]
    missed = {"n": n, "open": []} if gap else None
    seen = json.loads(snapshot(seq).body)
    told = {"since": f"abcdefgh-{n}", "gap": missed, "states": records, "snapshot": seen}
    return Answer(200, json.dumps(told).encode())


def test_events_go_on_where_the_last_ones_ended() -> None:
    scene = Scene(page(7, seq=1), page(8, record("started"), seq=2), page(30, seq=2, gap=True))
    since, first = scene.run(scene.talk.events(None, 0))
    assert [event.kind for event in first] == ["snapshot"]
    since, second = scene.run(scene.talk.events(since, 1))
    assert [event.kind for event in second] == ["snapshot", "command"]
    assert second[1].command is not None and second[1].command.state == "started"
    assert scene.run(scene.talk.events(since, 2))[1][0] == Event("gap")
    assert [request.url.split("/abc")[1] for request in scene.requests] == [
        "/events?wait=0",
        "/events?wait=10&since=abcdefgh-7&after=1",
        "/events?wait=10&since=abcdefgh-8&after=2",
    ]
