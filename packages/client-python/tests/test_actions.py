"""The JSON of commands, and errors of invalid numbers."""

import math
from typing import Any, Callable

import pytest
from corridor import CommandError
from corridor.actions import (
    Action,
    go_forward,
    go_reverse,
    is_endless,
    power_wheels,
    turn_by,
    turn_left,
    turn_right,
)

NEAR = {"sensor": "front", "is": "<=", "than": 60}
GOAL = {"goal": True}
TEXTS: Any = ["front"]


@pytest.mark.parametrize(
    ("action", "expected"),
    [
        (go_forward(None), {"action": "forward"}),
        (go_forward(100), {"action": "move", "distance": 100}),
        (go_forward(-10), {"action": "move", "distance": -10}),
        (go_reverse(None), {"action": "reverse"}),
        (go_reverse(24.5), {"action": "move", "distance": -24.5}),
        (go_forward(None, NEAR), {"action": "forward", "until": [NEAR]}),
        (go_reverse(None, [NEAR, GOAL]), {"action": "reverse", "until": [NEAR, GOAL]}),
        (
            power_wheels(0.2, 0.2, None, GOAL),
            {"action": "drive", "left": 0.2, "right": 0.2, "until": [GOAL]},
        ),
        (turn_left(90), {"action": "left 90"}),
        (turn_right(90.0), {"action": "right 90"}),
        (turn_left(45), {"action": "turn", "degrees": -45}),
        (turn_right(180), {"action": "turn", "degrees": 180}),
        (turn_by(-90), {"action": "turn", "degrees": -90}),
        (power_wheels(0.2, -0.2, None), {"action": "drive", "left": 0.2, "right": -0.2}),
        (
            power_wheels(1, 1, 500),
            {"action": "drive", "left": 1, "right": 1, "milliseconds": 500},
        ),
    ],
)
def test_each_method_creates_the_command_of_the_service(action: Action, expected: Action) -> None:
    assert action == expected


def test_a_motion_without_a_number_is_endless() -> None:
    assert is_endless(go_forward(None))
    assert is_endless(power_wheels(1, 1, None))
    assert not is_endless(power_wheels(1, 1, 500))
    assert not is_endless(go_reverse(10))
    assert not is_endless(go_forward(None, NEAR))
    assert not is_endless(power_wheels(1, 1, None, NEAR))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: go_forward(100, NEAR), r"forward\(\) does not accept a distance together with"),
        (lambda: go_reverse(100, NEAR), r"reverse\(\) does not accept a distance together with"),
        (lambda: power_wheels(0, 0, 9, NEAR), r"drive\(\) does not accept milliseconds together"),
        (lambda: go_forward(None, []), r"forward\(\) does not accept \[\] as until"),
        (lambda: go_forward(None, TEXTS), r"forward\(\) does not accept .* as until"),
    ],
)
def test_an_impossible_until_is_refused(make: Callable[[], Action], message: str) -> None:
    with pytest.raises(CommandError, match=message):
        make()


@pytest.mark.parametrize(
    ("method", "found", "message"),
    [
        (go_forward, "ten", r"forward\(\) does not accept 'ten' as distance .* -25600 to 25600 cm"),
        (go_reverse, True, r"reverse\(\) does not accept True"),
        (turn_left, math.nan, r"left\(\) does not accept nan as degrees"),
        (turn_right, 3601, r"right\(\) does not accept 3601 .* -3600 to 3600 degrees"),
        (lambda power: power_wheels(power, 0, None), 1.5, r"does not accept 1.5 as left"),
        (lambda time: power_wheels(0, 0, time), math.inf, r"does not accept inf as milliseconds"),
    ],
)
def test_an_invalid_number_is_rejected_locally(
    method: Callable[[Any], Action], found: Any, message: str
) -> None:
    with pytest.raises(CommandError, match=message) as error:
        method(found)
    assert error.value.code == "bad-command"
