"""A script and a robot at a real relay."""

import json
import threading
import time
import urllib.request
from typing import List, Tuple

import pytest
from conftest import Host
from corridor import (
    AddressError,
    Cell,
    ClosedError,
    CommandEndedError,
    CommandError,
    NoAnswerError,
    NoMazeError,
    NotAuthorisedError,
    Robot,
    RobotError,
    RobotGoneError,
    Snapshot,
)


def test_a_script_drives_reads_and_stops(corridor: Host) -> None:
    robot = Robot(corridor.address)
    assert robot.right(90).state == "completed"
    assert robot.sensor.front == 3_950
    moved = robot.forward(100)
    assert moved.distance == 100
    assert moved.pose is not None and (moved.pose.x, moved.pose.heading) == (250, 90)
    assert robot.sensor.front == 3_850
    assert robot.stop().state == "completed"
    assert [done["action"] for done in corridor.send("state")["done"]] == ["right 90", "move"]


def test_a_move_into_a_wall_returns_a_falsy_record(corridor: Host) -> None:
    robot = Robot(corridor.address)
    assert robot.forward(100).collided
    robot.right()
    steps = 0
    while robot.forward(100):
        steps += 1
    assert steps == 39


def test_the_log_contains_every_command_in_order(corridor: Host) -> None:
    robot = Robot(corridor.address)
    robot.right()
    robot.forward(100)
    assert robot.reverse(100).distance == 100
    assert [(each.seq, each.action, each.state) for each in robot.commands] == [
        (1, "right 90", "completed"),
        (2, "move", "completed"),
        (3, "move", "completed"),
    ]
    assert robot.commands[2].request == {"action": "move", "distance": -100}


def test_readings_follow_the_robot_while_others_drive_it(corridor: Host) -> None:
    reader, driver = Robot(corridor.address), Robot(corridor.address)
    driver.right()

    def drive() -> None:
        for _ in range(3):
            driver.forward(100)

    thread = threading.Thread(target=drive)
    thread.start()
    assert reader.wait_until(lambda sensor: sensor.back == 350, timeout=20).front == 3_650
    thread.join()
    seen = next(reader.snapshots())
    assert isinstance(seen, Snapshot) and seen.pose.x == 450


def test_commands_are_neither_lost_duplicated_nor_reordered_when_the_relay_is_killed(corridor: Host) -> None:
    robot = Robot(corridor.address)
    robot.right()

    def kill() -> None:
        for _ in range(2):
            time.sleep(0.1)
            corridor.send("kill")
            corridor.send("start")

    thread = threading.Thread(target=kill)
    thread.start()
    for _ in range(30):
        robot.forward(100)
    thread.join()
    log = robot.commands
    assert [each.seq for each in log] == list(range(1, len(log) + 1))
    assert {each.state for each in log} == {"completed"}
    state = corridor.send("state")
    assert len(state["done"]) == len(log) == 31
    assert state["pose"]["x"] == 150 + 100 * 30


def test_the_readings_of_one_decision_have_the_same_tick(
    corridor: Host,
) -> None:
    reader, driver = Robot(corridor.address), Robot(corridor.address)
    driver.right()

    def drive() -> None:
        for _ in range(39):
            driver.forward(100)

    thread = threading.Thread(target=drive)
    thread.start()
    sums = set()
    while thread.is_alive():
        # The corridor is 4,000 cm long.
        sums.add(reader.sensor.front + reader.sensor.back)
    thread.join()
    assert sums == {4_000}
    assert reader.sensors().back == 3_950


def test_the_goal_the_bumps_and_every_field_of_a_snapshot_are_available(corridor: Host) -> None:
    robot = Robot(corridor.address)
    assert not robot.goal_reached and robot.bumps == 0
    robot.forward(100)
    assert robot.bumps == 1
    seen = robot.snapshot()
    assert (seen.state, seen.driver, seen.motion, seen.bumping) == ("running", "remote", "stop", False)
    assert (seen.line, seen.command, seen.pose.cell) == (None, None, Cell(1, 1))


def publish_maze(host: Host, document: object) -> None:
    url = host.address.split("#")[0].replace("/r/", "/api/v1/robots/")
    request = urllib.request.Request(
        f"{url}/maze",
        json.dumps(document).encode(),
        {"Authorization": f"Bearer {host.owner_key}", "Content-Type": "application/json"},
        method="PUT",
    )
    urllib.request.urlopen(request).close()


def test_a_script_reads_the_maze_of_its_robot(corridor: Host) -> None:
    robot = Robot(corridor.address)
    with pytest.raises(NoMazeError) as error:
        robot.maze()
    assert error.value.code == "no-maze"
    document = {
        "format": "corridor/maze",
        "version": 1,
        "name": "Two cells",
        "blocks": ["####", "#..#", "####"],
        "start": {"column": 1, "row": 1, "heading": "east"},
        "goals": [{"column": 2, "row": 1}],
    }
    publish_maze(corridor, document)
    maze = robot.maze()
    assert (maze.name, maze.columns, maze.rows) == ("Two cells", 4, 3)
    assert (maze.start.cell, maze.start.heading, maze.goals) == (Cell(1, 1), "east", (Cell(2, 1),))
    cells = [(column, row) for row in range(-1, 4) for column in range(-1, 5)]
    assert [cell for cell in cells if maze.is_open(*cell)] == [(1, 1), (2, 1)]
    assert robot.snapshot().pose.cell == maze.start.cell


def test_a_reader_receives_every_command_and_the_newest_snapshot(corridor: Host) -> None:
    reader, driver = Robot(corridor.address), Robot(corridor.address)
    events = reader.events()
    first = next(events)
    assert first.kind == "snapshot" and first.snapshot is not None
    driver.right()
    driver.forward(100)
    states: List[Tuple[int, str]] = []
    headings = []
    while (2, "completed") not in states:
        event = next(events)
        if event.command is not None:
            states.append((event.command.seq, event.command.state))
        if event.snapshot is not None:
            headings.append(event.snapshot.pose.heading)
    order = ["accepted", "delivered", "started", "completed"]
    assert states == sorted(states, key=lambda each: (each[0], order.index(each[1])))
    assert [seq for seq, state in states if state == "completed"] == [1, 2]
    assert headings and headings[-1] == 90


def test_a_script_waits_for_a_page_that_reconnects(corridor: Host) -> None:
    robot = Robot(corridor.address)
    robot.snapshot()
    corridor.send("disconnect")
    timer = threading.Timer(0.5, lambda: corridor.send("connect"))
    timer.start()
    assert robot.right().state == "completed"
    assert robot.sensor.front == 3_950
    timer.join()


def test_a_page_that_stays_disconnected_is_reported(corridor: Host) -> None:
    robot = Robot(corridor.address, answer_timeout=1)
    robot.snapshot()
    corridor.send("disconnect")
    with pytest.raises(RobotGoneError, match="page is closed or not connected.*press Connect"):
        print(robot.sensor.front)


def test_an_expired_command_never_runs(corridor: Host) -> None:
    robot = Robot(corridor.address, ttl=0.3)
    corridor.send("disconnect")
    with pytest.raises(CommandEndedError) as error:
        robot.right()
    assert error.value.code == "expired"
    corridor.send("connect")
    assert robot.snapshot().pose.heading == 0
    assert corridor.send("state")["done"] == []
    with pytest.raises(CommandError, match="from 0.2 to 60 seconds"):
        Robot(corridor.address, ttl=100)


def test_the_end_of_the_block_stops_an_endless_motion(corridor: Host) -> None:
    with Robot(corridor.address) as robot:
        robot.right()
        robot.forward()
    with Robot(corridor.address) as other:
        assert [each.action for each in other.commands] == ["right 90", "forward", "stop"]
    with pytest.raises(ClosedError):
        robot.left()


def parts(address: str) -> Tuple[str, str]:
    url, key = address.split("#")
    return url, key


def test_each_wrong_address_has_its_own_error(corridor: Host) -> None:
    url, key = parts(corridor.address)
    assert repr(Robot(url, key=key)) == f"<Robot {url}>"
    with pytest.raises(NotAuthorisedError) as wrong_key:
        Robot(f"{url}#drv_AAAAAAAAAAAAAAAAAAAAAA")
    with pytest.raises(RobotGoneError) as no_robot:
        Robot(f"{corridor.origin}/r/AAAAAAAAAAAAAAAAAAAAAA#{key}")
    with pytest.raises(AddressError) as no_key:
        Robot(url)
    with pytest.raises(NoAnswerError) as no_host:
        Robot(f"http://127.0.0.1:9/r/abc#{key}", answer_timeout=0.5)
    codes = [error.value.code for error in (wrong_key, no_robot, no_key, no_host)]
    assert codes == ["not-authorised", "no-robot", "bad-address", "timeout"]
    for error in (wrong_key, no_robot, no_key, no_host):
        assert isinstance(error.value, RobotError)
        assert key not in str(error.value)
