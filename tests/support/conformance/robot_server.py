"""Starts robot hosts as forks of this process, because a fork is faster than a start of Python.

Each line of standard input is a JSON list: an id, the path of robot_host.py, and its arguments.
Each line of standard output is a JSON object with the id, the process id, and the robot's address
or the error. All hosts end when standard input is closed.
"""

import json
import os
import runpy
import signal
import sys
import traceback

# Modules of the standard library that the example uses: forks do not load them again.
import argparse, collections, dataclasses, datetime, hmac, http.server, math, re, secrets  # noqa: E401, F401
import threading, time, typing, urllib.parse  # noqa: E401, F401


class Output:
    """Standard output of a host, which writes its address."""

    def __init__(self, request_id: int) -> None:
        self._id = request_id

    def write(self, text: str) -> None:
        self.send(address=text.strip())

    def flush(self) -> None:
        pass

    def send(self, **fields: str) -> None:
        line = json.dumps({"id": self._id, "pid": os.getpid(), **fields})
        os.write(1, (line + "\n").encode())


def run_host(request_id: int, path: str, arguments: list) -> None:
    output = Output(request_id)
    try:
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        sys.stdout, sys.argv, sys.path[0] = output, [path, *arguments], os.path.dirname(path)
        runpy.run_path(path, run_name="__main__")
    except BaseException:
        output.send(error=traceback.format_exc())
    os._exit(1)


def main() -> None:
    os.setpgid(0, 0)
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)
    for line in iter(sys.stdin.readline, ""):
        request_id, path, *arguments = json.loads(line)
        if os.fork() == 0:
            run_host(request_id, path, arguments)
    os.killpg(0, signal.SIGKILL)


main()
