#!/usr/bin/env python3
"""Follow the right-hand wall through a maze.

Run it with the robot's address, which the page shows under Remote. Keep the quotes. If you cannot
copy the address, use a pairing code: see the README of the examples.

    python3 right_wall.py "http://localhost:8080/r/ID#KEY"

Requires Python 3.9 or newer and no packages. The robot follows the wall on its right: it turns
right at an opening, else drives straight ahead, else turns left.
"""

import argparse
import http.client
import itertools
import json
import random
import sys
import time
import urllib.error
import urllib.parse
import urllib.request
import uuid

CELL = 100  # one cell of the maze is 100 cm wide
OPEN = 60  # a larger distance means that the next cell is open
TIMEOUT = 30  # seconds without an answer after which the program gives up
NAME = "Right wall"  # the name of this program on the robot's page


class RobotError(Exception):
    """The robot or the service rejected a request, or did not answer."""


class NoRedirects(urllib.request.HTTPRedirectHandler):
    """Rejects redirects, so that the key is not sent to another host."""

    def redirect_request(self, *redirect):
        return None


class Robot:
    """A robot on the network. Every method waits until the robot has finished."""

    def __init__(self, address):
        parts = urllib.parse.urlsplit(address.strip())
        if not parts.fragment or not parts.path.startswith("/r/"):
            raise RobotError(
                "This is not a robot's address. Copy the whole address from the page, "
                'and put it in "quotes": the part after the # is the key.'
            )
        robot_id = parts.path[len("/r/"):]
        self.url = f"{parts.scheme}://{parts.netloc}/api/v1/robots/{robot_id}"
        self.key = parts.fragment
        self.opener = urllib.request.build_opener(NoRedirects)

    def snapshot(self):
        """Return the robot's sensors and pose, and whether it has reached the goal."""
        return self.request("GET", "/sensors?wait=10")

    def move(self, distance):
        """Drive a distance in cm. Return "completed", or "collided" if a wall stopped the robot."""
        return self.do({"action": "move", "distance": distance})

    def left90(self):
        return self.do({"action": "left 90"})

    def right90(self):
        return self.do({"action": "right 90"})

    def do(self, command):
        """Send a command, wait until it has ended, and return its state."""
        # The key makes a retry safe: a command that arrives twice runs once.
        record = self.request("POST", "/commands", command, key=uuid.uuid4().hex)
        while record["state"] in ("accepted", "delivered", "started"):
            record = self.request("GET", f"/commands/{record['seq']}?wait=10")
        if record["state"] not in ("completed", "collided"):
            raise RobotError(f"{record['action']} was {record['state']}: {record['reason']}")
        return record["state"]

    def request(self, method, path, body=None, key=None):
        """Send a request to the service. Retry after network errors and server errors."""
        headers = {
            "Authorization": f"Bearer {self.key}",
            "Content-Type": "application/json",
            "Script-Name": NAME,
        }
        if key is not None:
            headers["Idempotency-Key"] = key
        started = time.monotonic()
        for attempt in itertools.count():
            data = None
            if body is not None:
                # With the age in ms, the robot rejects a retry that arrives too late.
                age = round((time.monotonic() - started) * 1000)
                data = json.dumps({**body, "age": age}).encode()
            request = urllib.request.Request(self.url + path, data, headers, method=method)
            try:
                with self.opener.open(request, timeout=20) as response:
                    return json.load(response)
            except urllib.error.HTTPError as error:
                reason = explain(error)
                if error.code != 429 and error.code < 500:
                    raise RobotError(reason) from None
            except (OSError, http.client.HTTPException, ValueError) as error:
                reason = f"The service does not respond: {error}"
            # A random delay, so that the programs of a whole class do not retry at the same moment.
            delay = random.uniform(0, min(10, 0.25 * 2**attempt))
            if time.monotonic() + delay > started + TIMEOUT:
                raise RobotError(reason)
            time.sleep(delay)


def explain(error):
    """Return the error message of the service."""
    try:
        problem = json.load(error)
        fields = [f"{e['path']}: found {e['found']}, expected {e['expected']}" for e in problem["errors"]]
        return " ".join([problem["detail"], *fields])
    except (OSError, http.client.HTTPException, ValueError, KeyError, TypeError):
        return f"The service answered with status {error.code}."


def follow_right_wall(robot, until_cells, max_moves):
    """Drive until the goal is reached or enough cells are visited. Return the visited cells."""
    visited = set()
    moves = 0
    while True:
        snapshot = robot.snapshot()
        pose, sensors = snapshot["pose"], snapshot["sensors"]
        visited.add((int(pose["x"] // CELL), int(pose["y"] // CELL)))
        if until_cells is None and snapshot["goalReached"]:
            print(f"Goal reached after {moves} moves.")
            return visited
        if until_cells is not None and len(visited) >= until_cells:
            print(f"{len(visited)} cells visited after {moves} moves.")
            return visited
        if moves >= max_moves:
            raise RobotError(f"Goal not reached after {moves} moves; {len(visited)} cells visited.")

        if sensors["right"] > OPEN:
            print(f"{sensors['right']:.0f} cm on the right: turn right and drive")
            robot.right90()
            state = robot.move(CELL)
            moves += 1
        elif sensors["front"] > OPEN:
            print(f"{sensors['front']:.0f} cm ahead: drive on")
            state = robot.move(CELL)
            moves += 1
        else:
            print("Wall ahead and on the right: turn left")
            state = robot.left90()
        if state == "collided":
            print("Bumped into a wall!")


def main():
    parser = argparse.ArgumentParser(description="Follow the right-hand wall through a maze.")
    parser.add_argument("address", help='the robot\'s address, in "quotes"')
    parser.add_argument(
        "--until-cells", type=int, metavar="N", help="stop after N different cells, not at the goal"
    )
    parser.add_argument(
        "--moves", type=int, default=2000, metavar="N", help="give up after N moves (default 2000)"
    )
    options = parser.parse_args()
    try:
        follow_right_wall(Robot(options.address), options.until_cells, options.moves)
    except RobotError as error:
        sys.exit(str(error))
    except KeyboardInterrupt:
        sys.exit("Stopped with Ctrl+C.")


if __name__ == "__main__":
    main()
