"""AsyncRobot at a real relay."""

import asyncio
import time

import pytest
from conftest import Host
from corridor import AsyncRobot, NoMazeError, NotAuthorisedError


def test_a_script_drives_reads_and_stops(corridor: Host) -> None:
    async def script() -> None:
        async with AsyncRobot(corridor.address) as robot:
            await robot.right(90)
            assert (await robot.sensors()).front == 3_950
            assert await robot.forward(100)
            first = await robot.events().__anext__()
            assert first.snapshot is not None and first.snapshot.pose.x == 250
            with pytest.raises(NoMazeError):
                await robot.maze()
            await robot.forward()
        other = await AsyncRobot.connect(corridor.address)
        log = await other.commands()
        assert [each.action for each in log] == ["right 90", "move", "forward", "stop"]

    asyncio.run(script())


def test_other_tasks_run_while_one_waits(corridor: Host) -> None:
    async def script() -> int:
        ticks = 0
        driver = await AsyncRobot.connect(corridor.address)
        reader = await AsyncRobot.connect(corridor.address)
        await driver.right()
        waiting = asyncio.ensure_future(
            reader.wait_until(lambda sensor: sensor.back == 350, timeout=20)
        )
        for _ in range(3):
            await driver.forward(100)
            ticks += 1
        assert (await waiting).front == 3_650
        async for snapshot in reader.snapshots():
            assert snapshot.pose.x == 450
            break
        return ticks

    assert asyncio.run(script()) == 3


def test_a_script_exits_without_waiting_for_its_long_poll(corridor: Host) -> None:
    corridor.send("disconnect")

    async def script() -> None:
        robot = await AsyncRobot.connect(corridor.address)
        with pytest.raises(asyncio.TimeoutError):
            await asyncio.wait_for(robot.right(), 0.3)

    start = time.monotonic()
    asyncio.run(script())
    # The long poll would last 10 s.
    assert time.monotonic() - start < 8


def test_connect_raises_for_a_wrong_key(corridor: Host) -> None:
    async def script() -> None:
        await AsyncRobot.connect(corridor.address.split("#")[0], "drv_AAAAAAAAAAAAAAAAAAAAAA")

    with pytest.raises(NotAuthorisedError):
        asyncio.run(script())
