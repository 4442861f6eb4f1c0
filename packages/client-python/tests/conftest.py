"""The real relay with a robot on a grid behind it, in processes of their own."""

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any, Callable, Iterator, List

import pytest

PROJECT = Path(__file__).resolve().parents[3]
HOST = PROJECT / "packages/client/src/testing/robot-process.ts"

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
    """A relay and its robot, which obey the test."""

    def __init__(self, maze: List[str]) -> None:
        self._process = subprocess.Popen(
            [_node(), str(HOST), json.dumps(maze)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        said = self._hear()
        self.address: str = said["address"]
        self.origin: str = said["origin"]
        self.owner_key: str = said["ownerKey"]
        self.open_cells: int = said["openCells"]

    def tell(self, word: str) -> Any:
        """One of kill, start, leave, come, state."""
        assert self._process.stdin is not None
        self._process.stdin.write(word + "\n")
        self._process.stdin.flush()
        return self._hear()

    def close(self) -> None:
        assert self._process.stdin is not None
        self._process.stdin.close()
        try:
            self._process.wait(10)
        finally:
            self._process.kill()

    def _hear(self) -> Any:
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        assert line, "the relay and its robot did not start, or ended"
        return json.loads(line)


def _node() -> str:
    """Node 26, which npm has installed into the project."""
    own = PROJECT / "node_modules/.bin/node"
    found = str(own) if own.exists() else shutil.which("node")
    assert found, "There is no Node: run `npm ci` in the project first."
    return found


@pytest.fixture
def start() -> Iterator[Callable[[List[str]], Host]]:
    hosts: List[Host] = []

    def begin(maze: List[str]) -> Host:
        hosts.append(Host(maze))
        return hosts[-1]

    yield begin
    for host in hosts:
        host.close()


@pytest.fixture
def corridor(start: Callable[[List[str]], Host]) -> Host:
    """Forty cells in a row, from west to east; the robot stands in the first and faces north."""
    return start(CORRIDOR)


@pytest.fixture
def tree(start: Callable[[List[str]], Host]) -> Host:
    return start(TREE)


@pytest.fixture(autouse=True)
def no_proxy_of_the_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    """What the machine says of proxies is no part of a test."""
    for name in list(os.environ):
        if name.lower().endswith("_proxy"):
            monkeypatch.delenv(name)
