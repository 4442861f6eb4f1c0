"""The words, as they travel; and what is told about a number that cannot be."""

import math
from typing import Any, Callable

import pytest
from corridor import CommandError
from corridor.actions import (
    Action,
    go_forward,
    go_reverse,
    has_no_end,
    power_wheels,
    turn_by,
    turn_left,
    turn_right,
)


@pytest.mark.parametrize(
    ("action", "travels"),
    [
        (go_forward(None), {"action": "forward"}),
        (go_forward(100), {"action": "move", "distance": 100}),
        (go_forward(-10), {"action": "move", "distance": -10}),
        (go_reverse(None), {"action": "reverse"}),
        (go_reverse(24.5), {"action": "move", "distance": -24.5}),
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
def test_each_word_travels_as_the_service_takes_it(action: Action, travels: Action) -> None:
    assert action == travels


def test_a_motion_without_a_number_has_no_end() -> None:
    assert has_no_end(go_forward(None))
    assert has_no_end(power_wheels(1, 1, None))
    assert not has_no_end(power_wheels(1, 1, 500))
    assert not has_no_end(go_reverse(10))


@pytest.mark.parametrize(
    ("word", "found", "says"),
    [
        (go_forward, "ten", r"forward\(\) cannot take 'ten' as distance .* -25600 to 25600 cm"),
        (go_reverse, True, r"reverse\(\) cannot take True"),
        (turn_left, math.nan, r"left\(\) cannot take nan as degrees"),
        (turn_right, 3601, r"right\(\) cannot take 3601 .* -3600 to 3600 degrees"),
        (lambda power: power_wheels(power, 0, None), 1.5, r"cannot take 1.5 as left"),
        (lambda time: power_wheels(0, 0, time), math.inf, r"cannot take inf as milliseconds"),
    ],
)
def test_a_number_that_cannot_be_is_told_before_it_travels(
    word: Callable[[Any], Action], found: Any, says: str
) -> None:
    with pytest.raises(CommandError, match=says) as error:
        word(found)
    assert error.value.code == "bad-command"
