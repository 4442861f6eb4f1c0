#!/usr/bin/env python3
"""A robot on the network: start it, and give the address that it prints to any script.

    python3 robot_host.py

It needs Python 3.9 or newer and nothing else.
"""

import argparse
import secrets
import sys
from typing import Dict

from physical_robot.body import SimulatedBody
from physical_robot.ledger import Ledger
from physical_robot.pilot import Pilot
from physical_robot.server import RobotServer

#: The room in which the simulated robot stands; one character is one metre.
ROOM = "#######,#.#...#,#.#.#.#,#...#.#,#######"


def not_offered(options: argparse.Namespace, body: SimulatedBody) -> Dict[str, str]:
    """What this robot cannot do, and why. Its scripts and the conformance kit read it."""
    missing = {
        "maze": "It has no map of the room.",
        "websocket": "Libraries use the long-poll connection.",
    }
    if not options.tracked:
        missing["pose"] = "It counts the turns of its wheels: its pose is an estimate."
    if not body.has_goal:
        missing["goal"] = "There is no goal in its room."
    return missing


def main() -> None:
    parser = argparse.ArgumentParser(description="A host for a robot with two driven wheels.")
    parser.add_argument("--host", default="127.0.0.1", help="0.0.0.0 lets other machines in")
    parser.add_argument("--port", type=int, default=8090)
    parser.add_argument("--name", help="the name of this machine in the address (default: --host)")
    parser.add_argument("--room", default=ROOM, help="rows of # and ., with commas between")
    parser.add_argument("--haste", type=float, default=1.0, help="how many times faster it moves")
    parser.add_argument(
        "--tracked", action="store_true", help="its pose is measured, as by a camera above it"
    )
    options = parser.parse_args()

    robot_id, key = secrets.token_urlsafe(16), "drv_" + secrets.token_urlsafe(16)
    ledger = Ledger()
    body = SimulatedBody(options.room.split(","))
    pilot = Pilot(ledger, body, options.haste)
    place = (options.host, options.port)
    try:
        server = RobotServer(place, ledger, pilot, robot_id, key, not_offered(options, body))
    except OSError as error:
        sys.exit(f"The host cannot start on port {options.port}: {error}")
    pilot.start()
    where = options.name or options.host
    # In one piece, so that whoever reads the line may go away after it.
    sys.stdout.write(f"http://{where}:{server.server_port}/r/{robot_id}#{key}\n")
    sys.stdout.flush()
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        server.server_close()


if __name__ == "__main__":
    main()
