"""Names of other libraries in a Python script."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from corridor import AsyncRobot, LiveSensor, Robot, Sensors
from corridor.reports import read_snapshot

PACKAGE = Path(__file__).resolve().parents[1] / "src"


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
    assert str(error.value) == f"'{kind.__name__}' object has no attribute '{name}'. Use {usage}"
    assert not hasattr(robot, name)


def test_a_field_of_javascript_names_the_one_of_python() -> None:
    sensors = {"front": 1, "right": 1, "back": 1, "left": 1}
    pose = {"x": 50, "y": 50, "heading": 0}
    seen = {"seq": 1, "tick": 1, "state": "running", "driver": "me", "sensors": sensors, "pose": pose}
    rest = {"motion": "stop", "bumps": 0, "bumping": False, "goalReached": False, "command": None}
    snapshot: Any = read_snapshot({**seen, **rest, "line": None})
    for owner in (unconnected(Robot), snapshot):
        with pytest.raises(AttributeError, match="goalReached'. Use goal_reached$"):
            print(owner.goalReached)


@pytest.mark.parametrize("kind", [LiveSensor, Sensors])
def test_a_rear_sensor_is_the_back_one(kind: Any) -> None:
    with pytest.raises(AttributeError) as error:
        print(unconnected(kind).rear)
    assert str(error.value) == f"'{kind.__name__}' object has no attribute 'rear'. Use back"


def test_no_hint_names_a_private_part() -> None:
    # Python adds the most similar name when it prints the error.
    script = "from corridor import LiveSensor\nLiveSensor(print).rear\n"
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, env={"PYTHONPATH": str(PACKAGE)}, stderr=subprocess.PIPE, text=True)
    assert done.stderr.splitlines()[-1].endswith("has no attribute 'rear'. Use back")


def test_a_hint_and_the_most_similar_name_are_sentences_of_their_own() -> None:
    script = "from corridor import Robot\nRobot.__new__(Robot).goalReached\n"
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, env={"PYTHONPATH": str(PACKAGE)}, stderr=subprocess.PIPE, text=True)
    assert ".." not in done.stderr.splitlines()[-1]


def test_any_other_wrong_name_has_no_hint() -> None:
    with pytest.raises(AttributeError) as error:
        unconnected(Robot).fly()
    assert str(error.value) == "'Robot' object has no attribute 'fly'"
