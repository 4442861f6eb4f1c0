"""Hooks for schemathesis: existing robots and classes, valid keys and short waits.

schemathesis generates valid and invalid bodies, queries, headers and paths. Where a path is valid,
most calls go to an existing robot or class: nearly all others would end with "no such robot".
"""

import itertools
import json
import os
import random
import re
import time
import urllib.request

import schemathesis
from documents import apply_rules

SERVICE = os.environ["CORRIDOR_URL"]
ROBOTS = json.loads(os.environ["CORRIDOR_ROBOTS"])
CHANCE = random.Random(int(os.environ["CORRIDOR_SEED"]))
# Every call has its own address, as from many schools: the limits of an address are not under test.
ADDRESSES = (f"10.{n >> 16 & 255}.{n >> 8 & 255}.{n & 255}" for n in itertools.count(1))
MISSES = 0.1
WAIT = 0.02
MAZE = {
    "format": "corridor/maze",
    "version": 1,
    "name": "Hall",
    "blocks": ["#####", "#...#", "#####"],
    "start": {"column": 1, "row": 1, "heading": "east"},
    "goals": [{"column": 3, "row": 1}],
}
LESSON = {
    "format": "corridor/challenge",
    "version": 1,
    "name": "Drive there",
    "words": {"task": "Drive to the goal.", "short": "Drive", "hints": []},
    "mazes": [MAZE],
    "program": None,
    "goal": {"kind": "reach"},
    "allowed": {
        "drivers": ["program"],
        "lines": 5,
        "conditions": None,
        "actions": None,
        "edits": ["action"],
        "maze": False,
    },
    "checks": {"bumps": 0, "seconds": 20},
    "par": None,
}
CODE = r"[ -]*(?:[BCDFGHJKLMNPQRSTVWXZbcdfghjklmnpqrstvwxz][ -]*){8}"
CLASS_CODE = CODE.replace("{8}", "{6}")
MAX_TYPED = 32
MAX_EMBEDDED = 300
LINK = r"[BCDFGHJKLMNPQRSTVWXZbcdfghjklmnpqrstvwxz]{4,6}|[A-Za-z0-9_-]{12}"
# By role, the field of a class with the key.
ROLES = {"teach": "teacherKey", "show": "screenKey", "learn": "studentKey"}
KEY = r"[A-Za-z0-9_-]{8,64}"
SCRIPT_CLOCK = r"[A-Za-z0-9_-]{8,32} \d{1,15}"
MAX_BODY = 16 * 1024
MAX_DOCUMENT = 64 * 1024
DOCUMENTS = [
    "/api/v1/mazes",
    "/api/v1/robots/{id}/maze",
    "/api/v1/classes",
    "/api/v1/classes/{id}/lesson",
]
# Calls that delete the robot, exhaust its keys or connections, or block these hooks.
USES_UP = "deleteRobot createKey revokeKey openConnection closeConnection sendMessages fetchMessages blockScript".split()
# Calls that DELETE the list of commands, which stay readable. Robots of their own, because these hooks
# send new commands to the other ones, which schemathesis would take for deleted ones.
STOPPED = ROBOTS[:2]
MOVING = ROBOTS[2:]
STOP = {"action": "stop"}
INTERNALS = re.compile(
    r"node:|node_modules|file://|/src/|\.ts\b|\.js\b|\bat [\w.<>]+ \(|\bSQLITE_|/tmp/|/home/|/root/|Error:|ECONN|ENOENT"
)


def call(path, body=None, key=None, method=None):
    headers = {"Content-Type": "application/json", "X-Forwarded-For": next(ADDRESSES)}
    if key is not None:
        headers["Authorization"] = f"Bearer {key}"
    data = None if body is None else json.dumps(body).encode()
    method = method or ("GET" if data is None else "POST")
    request = urllib.request.Request(SERVICE + path, data, headers, method=method)
    with urllib.request.urlopen(request, timeout=20) as answer:
        return json.load(answer)


def fresh_robot():
    return call("/api/v1/robots", method="POST")


def connection_of(robot):
    hello = {"type": "hello", "version": 1, "role": "drive", "key": robot["driverKey"]}
    return call(f"/api/v1/robots/{robot['id']}/long-poll", hello)["key"]


def pairing_code():
    robot = CHANCE.choice(ROBOTS)
    return call(f"/api/v1/robots/{robot['id']}/pairing", key=robot["ownerKey"], method="POST")["code"]


def fresh_class():
    """A class with one student."""
    created = call("/api/v1/classes", {"lesson": LESSON})
    student = call("/api/v1/joins", {"code": created["code"]})
    return created | {"studentKey": student["key"], "student": student["student"]}


def class_connection(created):
    hello = {"type": "hello", "version": 1, "role": "learn", "key": created["studentKey"]}
    return call(f"/api/v1/classes/{created['id']}/long-poll", hello)["key"]


def store_program(created):
    key = class_connection(created)
    message = {"type": "program", "seq": 1, "task": 1, "link": "c1.AAAA"}
    path = f"/api/v1/classes/{created['id']}/long-poll/messages"
    call(path, {"first": 1, "messages": [message]}, key)
    # The response to it means that the program is stored.
    call(f"{path}?after=1&wait=5", key=key)


def is_valid(text, pattern):
    return isinstance(text, str) and re.fullmatch(pattern, text) is not None


@schemathesis.auth()
class Keys:
    """Puts an existing robot, command, key or document into a valid path, and its key into the header."""

    def get(self, case, context):
        return "set with each call"

    def set(self, case, data, context):
        case.headers["X-Forwarded-For"] = next(ADDRESSES)
        if case.meta is not None and case.meta.generation.mode.is_positive:
            case.body = apply_rules(case.body)
        operation = case.operation.definition.raw.get("operationId", "")
        schemes = {name for each in case.operation.definition.raw.get("security", []) for name in each}
        path = case.path_parameters
        if "/mazes/{id}" in case.operation.path:
            self.document(case, operation)
        elif operation == "describeEmbedding":
            self.embedding(case)
        elif "/classes/{id}" in case.operation.path:
            self.school_class(case, operation, schemes)
        elif operation == "joinClass" and isinstance(case.body, dict) and CHANCE.random() > MISSES:
            if is_valid(case.body.get("code"), CLASS_CODE) and len(case.body["code"]) <= MAX_TYPED:
                case.body["code"] = fresh_class()["code"]
        elif is_valid(path.get("id"), r"[A-Za-z0-9_-]{22}") and CHANCE.random() > MISSES:
            self.robot(case, operation, schemes)
        elif operation == "requestPairing" and isinstance(case.body, dict) and CHANCE.random() > MISSES:
            if is_valid(case.body.get("code"), CODE) and len(case.body["code"]) <= MAX_TYPED:
                case.body["code"] = pairing_code()
        elif operation == "awaitPairing" and schemes and CHANCE.random() > MISSES:
            pairing = call("/api/v1/pairing", {"code": pairing_code()})
            case.headers["Authorization"] = f"Bearer {pairing['key']}"
        if is_valid(str(case.query.get("wait")), r"\d{1,2}(\.\d{1,3})?"):
            case.query["wait"] = WAIT
        # Random times would mean that a request was delayed in transit, so send those of a real clock.
        if is_valid(case.headers.get("Script-Clock"), SCRIPT_CLOCK):
            clock = case.headers["Script-Clock"].split(" ")[0]
            case.headers["Script-Clock"] = f"{clock} {int(time.monotonic() * 1000)}"
        # A stream has no end to check. Invalid queries are rejected all the same.
        if operation == "followEvents" and "wait" not in case.query:
            case.query["wait"] = WAIT

    def document(self, case, operation):
        if not is_valid(case.path_parameters.get("id"), LINK):
            return
        if CHANCE.random() < MISSES:
            return
        stored = call("/api/v1/mazes", MAZE | {"name": f"Hall {CHANCE.random()}"})
        case.path_parameters["id"] = stored["id"]
        if operation == "deleteDocument":
            case.headers["Authorization"] = f"Bearer {stored['deleteKey']}"

    def embedding(self, case):
        url = case.query.get("url")
        if not isinstance(url, str) or not 0 < len(url) <= MAX_EMBEDDED or CHANCE.random() < MISSES:
            return
        stored = call("/api/v1/mazes", MAZE | {"name": f"Hall {CHANCE.random()}"})
        case.query["url"] = stored["address"]

    def school_class(self, case, operation, schemes):
        """Each call has its own class, because many calls end it, or remove its student."""
        path = case.path_parameters
        if not is_valid(path.get("id"), r"[A-Za-z0-9_-]{22}") or CHANCE.random() < MISSES:
            return
        created = fresh_class()
        path["id"] = created["id"]
        if is_valid(str(path.get("student")), r"\d{1,15}"):
            path["student"] = created["student"]
            # Schemathesis expects that everything in a class that it has created exists.
            if operation == "readStudentProgram":
                store_program(created)
        if operation == "openClassConnection" and isinstance(case.body, dict):
            if is_valid(case.body.get("key"), KEY):
                case.body["key"] = created[ROLES.get(str(case.body.get("role")), "teacherKey")]
        if "connectionKey" in schemes:
            case.headers["Authorization"] = f"Bearer {class_connection(created)}"
        elif schemes:
            name = CHANCE.choice(sorted(schemes))
            case.headers["Authorization"] = f"Bearer {created[name]}"

    def robot(self, case, operation, schemes):
        robot = CHANCE.choice(STOPPED if operation == "stopRobot" else MOVING)
        if operation in USES_UP:
            robot = fresh_robot()
        path = case.path_parameters
        path["id"] = robot["id"]
        api = f"/api/v1/robots/{robot['id']}"
        if is_valid(str(path.get("seq")), r"\d{1,15}"):
            path["seq"] = call(api + "/commands", STOP, robot["driverKey"])["seq"]
        if "keyId" in path and is_valid(path["keyId"], r"[A-Za-z0-9_-]{1,64}"):
            path["keyId"] = call(api + "/keys", key=robot["ownerKey"])["keys"][0]["id"]
        if operation == "openConnection" and isinstance(case.body, dict):
            if is_valid(case.body.get("key"), KEY):
                case.body["key"] = robot["driverKey"]
        if not schemes:
            return
        key = robot["ownerKey"] if "ownerKey" in schemes else robot["driverKey"]
        if "connectionKey" in schemes:
            key = connection_of(robot)
        case.headers["Authorization"] = f"Bearer {key}"


@schemathesis.hook
def filter_body(context, body):
    """JSON Schema cannot limit the bytes of a body, and the relay rejects larger ones."""
    limit = MAX_DOCUMENT if context.operation.path in DOCUMENTS else MAX_BODY
    return len(json.dumps(body, default=str)) <= limit


@schemathesis.check
def no_internals(context, response, case):
    """No file path and no stack trace reaches a client."""
    found = INTERNALS.search(response.text)
    if found is not None:
        raise AssertionError(f"The body shows internals: {found.group()!r}")
