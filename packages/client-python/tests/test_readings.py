"""The readings of one decision come from the same snapshot."""

import json
from typing import Any, List

from corridor.actions import go_forward
from corridor.reports import Event
from corridor.requests import Response
from test_protocol import Harness, record, snapshot


def read(harness: Harness, side: str) -> float:
    found: float = getattr(harness.run(harness.protocol.snapshot_for(side)).sensors, side)
    return found


def moving(count: int = 9) -> List[Any]:
    """Snapshots with different readings."""
    return [snapshot(seq, front=1_000 - 10 * seq, right=seq) for seq in range(1, count)]


def test_different_sides_in_one_decision_come_from_one_snapshot() -> None:
    harness = Harness(*moving())
    assert [read(harness, "right"), read(harness, "front")] == [1, 990]
    assert len(harness.requests) == 1


def test_reading_a_side_again_starts_a_new_decision() -> None:
    harness = Harness(*moving())
    pairs = [(read(harness, "right"), read(harness, "front")) for _ in range(3)]
    assert pairs == [(1, 990), (2, 980), (3, 970)]
    # As in `if right > 60 and front < 60`, which does not always read the second.
    assert [read(harness, "right"), read(harness, "right"), read(harness, "front")] == [4, 5, 950]


def test_a_decision_ends_after_a_tenth_of_a_second() -> None:
    harness = Harness(*moving())
    read(harness, "right")
    harness.now += 0.09
    assert read(harness, "front") == 990
    harness.now += 0.02
    assert read(harness, "left") == 50 and len(harness.requests) == 2


def test_a_command_ends_a_decision() -> None:
    harness = Harness(snapshot(1, front=150), record("completed"), snapshot(9, front=50))
    read(harness, "right")
    harness.run(harness.protocol.execute(go_forward(100)))
    assert read(harness, "front") == 50


def page(n: int, *states: Response, seq: int, gap: bool = False) -> Response:
    records = [{"n": n, "record": json.loads(state.body)} for state in states]
    missed = {"n": n, "open": []} if gap else None
    seen = json.loads(snapshot(seq).body)
    body = {"since": f"abcdefgh-{n}", "gap": missed, "states": records, "snapshot": seen}
    return Response(200, json.dumps(body).encode())


def test_events_continue_after_the_last_ones() -> None:
    harness = Harness(page(7, seq=1), page(8, record("started"), seq=2), page(30, seq=2, gap=True))
    since, first = harness.run(harness.protocol.events(None, 0))
    assert [event.kind for event in first] == ["snapshot"]
    since, second = harness.run(harness.protocol.events(since, 1))
    assert [event.kind for event in second] == ["snapshot", "command"]
    assert second[1].command is not None and second[1].command.state == "started"
    assert harness.run(harness.protocol.events(since, 2))[1][0] == Event("gap")
    assert [request.url.split("/abc")[1] for request in harness.requests] == [
        "/events?wait=0",
        "/events?wait=10&since=abcdefgh-7&after=1",
        "/events?wait=10&since=abcdefgh-8&after=2",
    ]
