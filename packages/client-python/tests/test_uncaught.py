"""The output of a script with an uncaught error."""

import signal
import subprocess
import sys
import urllib.request
from pathlib import Path
from typing import Callable, List

import pytest
from conftest import Host
from corridor import Robot

PACKAGE = Path(__file__).resolve().parents[1] / "src"

SYNC = """from corridor import Robot
robot = Robot({address!r})
robot.right()
"""
ASYNC = """import asyncio
from corridor import AsyncRobot

async def main():
    async with AsyncRobot({address!r}) as robot:
        await robot.right()

asyncio.run(main())
"""
AWAIT = "6: await robot.right()"
# As asyncio.run of Python 3.9 and 3.10, which does not cancel the script before Ctrl+C is raised.
OLD_ASYNC = ASYNC.replace("asyncio.run(main())", "asyncio.new_event_loop().run_until_complete(main())")


@pytest.fixture
def run(tmp_path: Path) -> Callable[..., "subprocess.CompletedProcess[str]"]:
    def run_script(text: str, *options: str) -> "subprocess.CompletedProcess[str]":
        (tmp_path / "first.py").write_text(text)
        return subprocess.run(
            [sys.executable, *options, "first.py"],
            cwd=tmp_path,
            env={"PYTHONPATH": str(PACKAGE)},
            capture_output=True,
            text=True,
        )

    return run_script


def pause(host: Host) -> None:
    url = host.address.split("#")[0].replace("/r/", "/api/v1/robots/")
    headers = {"Authorization": f"Bearer {host.owner_key}"}
    request = urllib.request.Request(f"{url}/pause", headers=headers, method="PUT")
    urllib.request.urlopen(request).close()


@pytest.mark.parametrize("text, line", [(SYNC, "3: robot.right()"), (ASYNC, "6: await robot.right()")])
def test_it_is_the_line_of_the_script_and_a_sentence(
    corridor: Host,
    run: Callable[..., "subprocess.CompletedProcess[str]"],
    text: str,
    line: str,
) -> None:
    pause(corridor)
    done = run(text.format(address=corridor.address))
    lines: List[str] = done.stderr.splitlines()
    assert done.returncode == 1 and done.stdout == ""
    assert lines[0] == f"first.py, line {line}"
    assert len(lines) == 2 and "paused" in lines[1] and lines[1].endswith(".")
    assert corridor.address.split("#")[1] not in done.stderr


def test_it_does_not_repeat_an_invalid_address(
    run: Callable[..., "subprocess.CompletedProcess[str]"],
) -> None:
    done = run("from corridor import Robot\nRobot('http://localhost/r/abc')\n")
    assert done.stderr.splitlines()[-1].startswith("This is not a robot's address. The key")
    assert "Traceback" not in done.stderr


def test_it_is_a_traceback_in_development_mode_and_for_other_errors(
    run: Callable[..., "subprocess.CompletedProcess[str]"],
) -> None:
    wrong = "from corridor import Robot\nRobot('http://localhost/r/abc')\n"
    assert "Traceback" in run(wrong, "-X", "dev").stderr
    done = run("import corridor\n1 / 0\n")
    assert "Traceback" in done.stderr and done.returncode == 1


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGINT for one process")
@pytest.mark.parametrize(
    "text, lines",
    [
        (SYNC, ["3: robot.right()"]),
        (ASYNC, [AWAIT] if sys.version_info >= (3, 11) else [AWAIT, "8: asyncio.run(main())"]),
        # It depends on the moment: the script runs a step of the command, or the event loop waits.
        (OLD_ASYNC, [AWAIT, "8: asyncio.new_event_loop().run_until_complete(main())"]),
    ],
)
def test_ctrl_c_during_a_command_prints_the_line_of_the_script(
    corridor: Host, tmp_path: Path, text: str, lines: List[str]
) -> None:
    corridor.send("disconnect")
    (tmp_path / "first.py").write_text(text.format(address=corridor.address))
    script = subprocess.Popen(
        [sys.executable, "first.py"],
        cwd=tmp_path,
        env={"PYTHONPATH": str(PACKAGE)},
        stderr=subprocess.PIPE,
        text=True,
    )
    reader = Robot(corridor.address)
    while not reader.commands:
        assert script.poll() is None
    script.send_signal(signal.SIGINT)
    _, printed = script.communicate(timeout=20)
    assert script.returncode == -signal.SIGINT
    # The shell reports a script that Ctrl+C has ended as 130.
    assert printed in [f"Stopped by Ctrl+C: first.py, line {line}\n" for line in lines]
