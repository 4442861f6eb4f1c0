"""The rules between the fields of a body, which no JSON Schema can express: every correct client keeps them."""

import copy

DEFAULT_TTL = 10_000
# The relay refuses a command that is older than its time to live: a client does not send it any more.
YOUNG = 0.5


def keep_rules(body):
    """A body like this one, which fulfils its schema, that fulfils the rules between its fields, too."""
    if not isinstance(body, dict):
        return body
    body = copy.deepcopy(body)
    if body.get("format") == "corridor/maze":
        keep_maze_rules(body)
    elif body.get("format") == "corridor/challenge":
        keep_challenge_rules(body)
    elif "action" in body and "age" in body:
        body["age"] = min(body["age"], YOUNG * body.get("ttl", DEFAULT_TTL))
    return body


def keep_maze_rules(maze):
    """Rows of one length; start and goals inside, on open cells."""
    width = len(maze["blocks"][0])
    rows = [list(row[:width].ljust(width, "#")) for row in maze["blocks"]]
    for cell in [maze["start"], *maze["goals"]]:
        cell["column"] = int(cell["column"]) % width
        cell["row"] = int(cell["row"]) % len(rows)
        rows[cell["row"]][cell["column"]] = "."
    maze["blocks"] = ["".join(row) for row in rows]


def keep_challenge_rules(challenge):
    """What is to be done can be done in its mazes, in the time and with the lines that it gives."""
    goal, checks, program = challenge["goal"], challenge["checks"], challenge["program"]
    for maze in challenge["mazes"]:
        keep_maze_rules(maze)
        if goal["kind"] == "reach" and not maze["goals"]:
            maze["goals"] = [{name: maze["start"][name] for name in ("column", "row")}]
    if goal["kind"] == "stop":
        goal["from"], goal["to"] = sorted([goal["from"], goal["to"]])
    if goal["kind"] == "last":
        goal["seconds"] = min(goal["seconds"], checks["seconds"])
    if program is not None:
        challenge["allowed"]["lines"] = max(challenge["allowed"]["lines"], len(program["rules"]))
