#!/usr/bin/env python3
"""Follow the right-hand wall through a maze.

Run it with the robot's address, as the page shows it under Remote (keep the quotes; where it cannot
be copied, a code gets one: see the README of the examples):

    python3 right_wall.py "http://localhost:8080/r/ID#KEY"

It needs Python 3.9 or newer and nothing else. The robot keeps its right hand on the wall:
where there is an opening on the right it goes in, else straight on, else it turns left.
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
OPEN = 60  # farther than this, and there is no wall in the next cell
PATIENCE = 30  # seconds that the service may stay silent
NAME = "Right wall"  # what the robot's owner sees of this program


class RobotError(Exception):
    """The robot, or the service that carries the messages, said no."""


class NoRedirects(urllib.request.HTTPRedirectHandler):
    """The key goes to the host of the address and to no other."""

    def redirect_request(self, *redirect):
        return None


class Robot:
    """A robot somewhere on the network. Every method waits until the robot has done it."""

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

    def look(self):
        """All that the robot knows now: its sensors, its place, whether it is at the goal."""
        return self.ask("GET", "/sensors?wait=10")

    def move(self, distance):
        """Drive so many centimetres. Says "completed", or "collided" if a wall was in the way."""
        return self.do({"action": "move", "distance": distance})

    def left90(self):
        return self.do({"action": "left 90"})

    def right90(self):
        return self.do({"action": "right 90"})

    def do(self, command):
        """Send a command, wait until it has ended, and say how."""
        # The key makes a retry safe: a command that arrives twice is done once.
        record = self.ask("POST", "/commands", command, key=uuid.uuid4().hex)
        while record["state"] in ("accepted", "delivered", "started"):
            record = self.ask("GET", f"/commands/{record['seq']}?wait=10")
        if record["state"] not in ("completed", "collided"):
            raise RobotError(f"{record['action']} was {record['state']}: {record['reason']}")
        return record["state"]

    def ask(self, method, path, body=None, key=None):
        """One request to the service. Tries again when the network or the service has a bad moment."""
        headers = {
            "Authorization": f"Bearer {self.key}",
            "Content-Type": "application/json",
            "Script-Name": NAME,
        }
        if key is not None:
            headers["Idempotency-Key"] = key
        first_try = time.monotonic()
        for tries in itertools.count():
            data = None
            if body is not None:
                # By its age (in ms) a command that is sent again is never done late.
                age = round((time.monotonic() - first_try) * 1000)
                data = json.dumps({**body, "age": age}).encode()
            request = urllib.request.Request(self.url + path, data, headers, method=method)
            try:
                with self.opener.open(request, timeout=20) as answer:
                    return json.load(answer)
            except urllib.error.HTTPError as error:
                reason = explain(error)
                if error.code != 429 and error.code < 500:
                    raise RobotError(reason) from None
            except (OSError, http.client.HTTPException, ValueError) as error:
                reason = f"The service does not answer: {error}"
            # Drawn by lot, so that a whole class does not come back in the same moment.
            pause = random.uniform(0, min(10, 0.25 * 2**tries))
            if time.monotonic() + pause > first_try + PATIENCE:
                raise RobotError(reason)
            time.sleep(pause)


def explain(error):
    """The sentence in which the service says what is wrong."""
    try:
        problem = json.load(error)
        fields = [f"{e['path']}: found {e['found']}, expected {e['expected']}" for e in problem["errors"]]
        return " ".join([problem["detail"], *fields])
    except (OSError, http.client.HTTPException, ValueError, KeyError, TypeError):
        return f"The service answered with status {error.code}."


def follow_right_wall(robot, until_cells, most_moves):
    """Go on until the goal is reached, or enough cells are visited. Gives the visited cells."""
    visited = set()
    moves = 0
    while True:
        seen = robot.look()
        pose, sensors = seen["pose"], seen["sensors"]
        visited.add((int(pose["x"] // CELL), int(pose["y"] // CELL)))
        if until_cells is None and seen["goalReached"]:
            print(f"Goal reached after {moves} moves.")
            return visited
        if until_cells is not None and len(visited) >= until_cells:
            print(f"{len(visited)} cells visited after {moves} moves.")
            return visited
        if moves >= most_moves:
            raise RobotError(f"Not there after {moves} moves; {len(visited)} cells visited.")

        if sensors["right"] > OPEN:
            print(f"{sensors['right']:.0f} cm on the right: turn right and go")
            robot.right90()
            how = robot.move(CELL)
            moves += 1
        elif sensors["front"] > OPEN:
            print(f"{sensors['front']:.0f} cm ahead: go on")
            how = robot.move(CELL)
            moves += 1
        else:
            print("Wall ahead and on the right: turn left")
            how = robot.left90()
        if how == "collided":
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
        sys.exit("Stopped by you.")


if __name__ == "__main__":
    main()
