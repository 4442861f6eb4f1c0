"""Names of HTTP and of the JavaScript library in a Python script."""

from typing import Any

import pytest
from corridor import AsyncRobot, Robot
from corridor.reports import read_snapshot


def unconnected(kind: Any) -> Any:
    return kind.__new__(kind)


@pytest.mark.parametrize("kind", [Robot, AsyncRobot])
@pytest.mark.parametrize(
    ("name", "usage"),
    [
        ("move", "forward(100)"),
        ("left90", "left(90)"),
        ("right90", "right(90)"),
        ("turn180", "turn(180)"),
        ("delayedLeft90", "delayed_left()"),
        ("delayedRight90", "delayed_right()"),
    ],
)
def test_a_command_of_javascript_names_the_one_of_python(kind: Any, name: str, usage: str) -> None:
    robot = unconnected(kind)
    with pytest.raises(AttributeError) as error:
        getattr(robot, name)
    assert str(error.value) == f"'{kind.__name__}' object has no attribute '{name}'. Use {usage}."
    assert not hasattr(robot, name)


def test_a_field_of_javascript_names_the_one_of_python() -> None:
    sensors = {"front": 1, "right": 1, "back": 1, "left": 1}
    pose = {"x": 50, "y": 50, "heading": 0}
    seen = {"seq": 1, "tick": 1, "state": "running", "driver": "me", "sensors": sensors, "pose": pose}
    rest = {"motion": "stop", "bumps": 0, "bumping": False, "goalReached": False, "command": None}
    snapshot: Any = read_snapshot({**seen, **rest, "line": None})
    for owner in (unconnected(Robot), snapshot):
        with pytest.raises(AttributeError, match="goalReached'. Use goal_reached.$"):
            print(owner.goalReached)


def test_any_other_wrong_name_has_no_hint() -> None:
    with pytest.raises(AttributeError) as error:
        unconnected(Robot).fly()
    assert str(error.value) == "'Robot' object has no attribute 'fly'"
