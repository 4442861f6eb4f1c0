#!/usr/bin/env python3
"""Starts a robot host and prints the robot's address, which any script can use.

    python3 robot_host.py

Requires Python 3.9 or newer and no packages.
"""

import argparse
import secrets
import sys
from typing import Dict

from physical_robot.body import SimulatedBody
from physical_robot.command_store import CommandStore
from physical_robot.controller import Controller
from physical_robot.server import RobotServer

#: Plan of the simulated room; one character is one metre.
ROOM = "#######,#.#...#,#.#.#.#,#...#.#,#######"


def not_offered(options: argparse.Namespace, body: SimulatedBody) -> Dict[str, str]:
    """Unsupported features with reasons, for scripts and the conformance kit."""
    missing = {
        "maze": "It has no map of the room.",
        "websocket": "Libraries use the long-poll connection.",
    }
    if not options.tracked:
        missing["pose"] = "It counts the turns of its wheels: its pose is an estimate."
    if not options.reset:
        missing["reset"] = "It cannot put itself at its start: carry it there."
    if not body.has_goal:
        missing["goal"] = "There is no goal in its room."
    return missing


def main() -> None:
    parser = argparse.ArgumentParser(description="A host for a robot with two driven wheels.")
    parser.add_argument(
        "--host", default="127.0.0.1", help="address to listen on; 0.0.0.0 allows other machines"
    )
    parser.add_argument("--port", type=int, default=8090)
    parser.add_argument("--name", help="host name in the robot's address (default: --host)")
    parser.add_argument(
        "--room",
        default=ROOM,
        help="rows of # (block), . (floor), S (start) and G (goal), separated by commas",
    )
    parser.add_argument(
        "--speedup", type=float, default=1.0, help="factor by which the simulated motors are faster"
    )
    parser.add_argument(
        "--tracked", action="store_true", help="the pose is measured, for example by a camera"
    )
    parser.add_argument(
        "--reset", action="store_true", help="scripts may put the simulated body at its start"
    )
    options = parser.parse_args()

    robot_id, key = secrets.token_urlsafe(16), "drv_" + secrets.token_urlsafe(16)
    store = CommandStore(can_reset=options.reset)
    body = SimulatedBody(options.room.split(","))
    controller = Controller(store, body, options.speedup)
    address = (options.host, options.port)
    try:
        server = RobotServer(address, store, controller, robot_id, key, not_offered(options, body))
    except OSError as error:
        sys.exit(f"The host cannot start on port {options.port}: {error}")
    controller.start()
    host = options.name or options.host
    # A single write, so that a reader can close the pipe after the first line.
    sys.stdout.write(f"http://{host}:{server.server_port}/r/{robot_id}#{key}\n")
    sys.stdout.flush()
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        server.server_close()


if __name__ == "__main__":
    main()
