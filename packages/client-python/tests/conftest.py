"""Fixtures with a real relay and a grid robot, in their own processes."""

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any, Callable, Iterator, List

import pytest

PROJECT = Path(__file__).resolve().parents[3]
HOST = PROJECT / "tests/support/client/robot-process.ts"

TREE = [
    "#########",
    "#.#.....#",
    "#.#.###.#",
    "#...#...#",
    "#.#######",
    "#.#.#...#",
    "#.#.#.###",
    "#.....###",
    "#########",
]
CORRIDOR = ["#" * 42, "#" + "." * 40 + "#", "#" * 42]


class Host:
    """A relay process and its robot, controlled by the test."""

    def __init__(self, maze: List[str]) -> None:
        self._process = subprocess.Popen(
            [_node(), str(HOST), json.dumps(maze)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        started = self._read()
        self.address: str = started["address"]
        self.origin: str = started["origin"]
        self.owner_key: str = started["ownerKey"]
        self.open_cells: int = started["openCells"]

    def send(self, instruction: str) -> Any:
        """Sends one of kill, start, disconnect, connect, state. Returns the result."""
        assert self._process.stdin is not None
        self._process.stdin.write(instruction + "\n")
        self._process.stdin.flush()
        return self._read()

    def close(self) -> None:
        assert self._process.stdin is not None
        self._process.stdin.close()
        try:
            self._process.wait(10)
        finally:
            self._process.kill()

    def _read(self) -> Any:
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        assert line, "The relay process did not start, or has exited"
        return json.loads(line)


def _node() -> str:
    """The Node of the project, or the installed one."""
    own = PROJECT / "node_modules/.bin/node"
    found = str(own) if own.exists() else shutil.which("node")
    assert found, "Node is missing: run `npm ci` in the project first."
    return found


@pytest.fixture
def start() -> Iterator[Callable[[List[str]], Host]]:
    hosts: List[Host] = []

    def start_host(maze: List[str]) -> Host:
        hosts.append(Host(maze))
        return hosts[-1]

    yield start_host
    for host in hosts:
        host.close()


@pytest.fixture
def corridor(start: Callable[[List[str]], Host]) -> Host:
    """Forty cells from west to east. The robot stands in the first one and faces north."""
    return start(CORRIDOR)


@pytest.fixture
def tree(start: Callable[[List[str]], Host]) -> Host:
    return start(TREE)


@pytest.fixture(autouse=True)
def without_proxy(monkeypatch: pytest.MonkeyPatch) -> None:
    """Tests ignore the proxy settings of the machine."""
    for name in list(os.environ):
        if name.lower().endswith("_proxy"):
            monkeypatch.delenv(name)
