"""Rules between the fields of a body that JSON Schema cannot express. Every correct client follows them."""

import copy

DEFAULT_TTL = 10_000
# The relay rejects a command that is older than its time to live, so a client stops sending it.
YOUNG = 0.5


def apply_rules(body):
    """Returns a copy of a body that fulfils its schema, changed to fulfil the rules between its fields."""
    if not isinstance(body, dict):
        return body
    body = copy.deepcopy(body)
    if body.get("format") == "corridor/maze":
        apply_maze_rules(body)
    elif body.get("format") == "corridor/project":
        apply_maze_rules(body["maze"])
    elif body.get("format") == "corridor/challenge":
        apply_lesson_rules(body)
    elif "lesson" in body:
        apply_lesson_rules(body["lesson"])
        apply_name_rules(body)
    elif "action" in body and "age" in body:
        body["age"] = min(body["age"], YOUNG * body.get("ttl", DEFAULT_TTL))
    return body


def apply_maze_rules(maze):
    """Rows of one length; start and goals inside, on open cells."""
    width = len(maze["blocks"][0])
    rows = [list(row[:width].ljust(width, "#")) for row in maze["blocks"]]
    for cell in [maze["start"], *maze["goals"]]:
        cell["column"] = int(cell["column"]) % width
        cell["row"] = int(cell["row"]) % len(rows)
        rows[cell["row"]][cell["column"]] = "."
    maze["blocks"] = ["".join(row) for row in rows]


def apply_lesson_rules(lesson):
    """A challenge document of either version."""
    for task in lesson.get("tasks", [lesson]):
        apply_challenge_rules(task)
    if "survey" in lesson:
        lesson["survey"] = list({each["id"]: each for each in lesson["survey"]}.values())


def apply_name_rules(request):
    """Different names without spaces around them and without control characters."""
    if request.get("names"):
        names = ("".join(c for c in name if c.isprintable()).strip()[:12] for name in request["names"])
        request["names"] = list(dict.fromkeys(name or "Ada" for name in names))


def apply_challenge_rules(challenge):
    """Makes the goal reachable in its mazes, within its time and with its lines, and sides odd."""
    goal, checks, program = challenge["goal"], challenge["checks"], challenge["program"]
    for maze in challenge["mazes"]:
        apply_maze_rules(maze)
        if goal["kind"] == "reach" and not maze["goals"]:
            maze["goals"] = [{name: maze["start"][name] for name in ("column", "row")}]
    if goal["kind"] == "stop":
        goal["from"], goal["to"] = sorted([goal["from"], goal["to"]])
    if goal["kind"] == "last":
        goal["seconds"] = min(goal["seconds"], checks["seconds"])
    if program is not None:
        challenge["allowed"]["lines"] = max(challenge["allowed"]["lines"], len(program["rules"]))
    unseen = challenge.get("unseen")
    if unseen:
        unseen["pass"] = min(unseen["pass"], unseen["count"])
        for side in ("columns", "rows"):
            unseen[side] = int(unseen[side]) | 1
