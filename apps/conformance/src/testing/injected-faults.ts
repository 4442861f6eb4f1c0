/**
 * Faults for the example of a physical robot: a description, the edits of its Python source, and
 * the promise whose check must fail first.
 */
import type { InjectedFault } from "./injected-fault.ts";
import { messageFlow } from "./message-flow-faults.ts";
import type { BridgeFault, Message } from "./websocket-bridge.ts";

const BODY = "physical_robot/body.py";
const HOST = "robot_host.py";
const COMMAND_STORE = "physical_robot/command_store.py";
const LONG_POLL = "physical_robot/long_poll.py";
const COMMAND_REQUESTS = "physical_robot/command_requests.py";
const CONTROLLER = "physical_robot/controller.py";
const VALIDATION = "physical_robot/validation.py";
const SERVER = "physical_robot/server.py";

/** A fault that replaces one text of the source. */
function fault(caughtBy: string, what: string, file: string, before: string, after: string) {
  return { fault: what, caughtBy, edits: [{ file, before, after }] };
}

const access: InjectedFault[] = [
  fault("key-address", "the log cannot be read", SERVER, '"GET": lambda: self._log(query),', ""),
  fault(
    "key-required",
    "401 does not ask for a bearer key",
    SERVER,
    'raise Problem(401, "not-authorised", detail, headers={"WWW-Authenticate": "Bearer"})',
    'raise Problem(401, "not-authorised", detail)',
  ),
  fault(
    "key-wrong",
    "any key that looks like one drives",
    SERVER,
    "not hmac.compare_digest(key.encode(), self.server.key.encode())",
    "not key.startswith(self.server.key[:8])",
  ),
  fault(
    "key-secret",
    "a refusal repeats the key that was sent",
    SERVER,
    'raise Problem(401, "not-authorised", detail, headers=',
    'raise Problem(401, "not-authorised", f"{detail} Not {key}.", headers=',
  ),
  fault(
    "features",
    "the host says that it cannot stop",
    HOST,
    '"maze": "It has no map of the room.",',
    '"maze": "It has no map of the room.", "stop": "It has no brakes.",',
  ),
];

const directions: InjectedFault[] = [
  fault(
    "unit-length",
    "readings in millimetres",
    BODY,
    "round(self._range(angle), 2)",
    "round(self._range(angle) * 10, 2)",
  ),
  {
    fault: "readings from before an ending",
    caughtBy: "fresh-reading",
    edits: [
      {
        file: CONTROLLER,
        before: "        self._report()\n        return self._pose()",
        after: "        return self._pose()",
      },
      { file: CONTROLLER, before: "REPORT_MOVING = 0.05", after: "REPORT_MOVING = 0.5" },
    ],
  },
  fault(
    "sides",
    "left and right swapped",
    BODY,
    '"right": 90, "back": 180, "left": 270',
    '"right": 270, "back": 180, "left": 90',
  ),
  fault(
    "sides",
    "front and back swapped",
    BODY,
    '"front": 0, "right": 90, "back": 180',
    '"front": 180, "right": 90, "back": 0',
  ),
  fault(
    "turn-left",
    "left 90 turns right",
    CONTROLLER,
    '"left 90": [("turn", -90)]',
    '"left 90": [("turn", 90)]',
  ),
  fault(
    "turn-right",
    "right 90 turns left",
    CONTROLLER,
    '"right 90": [("turn", 90)]',
    '"right 90": [("turn", -90)]',
  ),
  fault("turn-half", "turn 180 turns a quarter", CONTROLLER, '("turn", 180)', '("turn", 90)'),
  fault(
    "turn-whole",
    "right 90 turns by 80 degrees",
    CONTROLLER,
    '"right 90": [("turn", 90)]',
    '"right 90": [("turn", 80)]',
  ),
  fault(
    "turn-degrees",
    "degrees count to the left",
    CONTROLLER,
    '("turn", command["degrees"])',
    '("turn", -command["degrees"])',
  ),
  fault(
    "move-distance",
    "move drives half the distance",
    CONTROLLER,
    '("move", command["distance"])',
    '("move", command["distance"] / 2)',
  ),
  fault(
    "move-backward",
    "a move below 0 drives ahead",
    CONTROLLER,
    '("move", command["distance"])',
    '("move", abs(command["distance"]))',
  ),
  fault(
    "record-distance",
    "a record tells half of the way",
    CONTROLLER,
    "round(self._distance, 2)",
    "round(self._distance / 2, 2)",
  ),
  fault(
    "milliseconds",
    "drive lasts for half of its milliseconds",
    CONTROLLER,
    'command["milliseconds"] / 1_000',
    'command["milliseconds"] / 2_000',
  ),
  fault(
    "wheels",
    "the wheels are swapped",
    CONTROLLER,
    'command["left"] * WHEEL_SPEED, command["right"] * WHEEL_SPEED',
    'command["right"] * WHEEL_SPEED, command["left"] * WHEEL_SPEED',
  ),
  fault(
    "forward-reverse",
    "reverse drives ahead",
    CONTROLLER,
    'SPEED if command["action"] == "forward" else -SPEED',
    "SPEED",
  ),
  fault(
    "collision",
    "a move that met a wall counts as completed",
    CONTROLLER,
    "self._collided = True",
    "self._collided = False",
  ),
  fault("collision", "one contact counts as two bumps", BODY, "self.bumps += 1", "self.bumps += 2"),
  fault(
    "collision-forward",
    "forward pushes against the wall",
    CONTROLLER,
    '            if self._body.bumping:\n                self._end(entry, "collided")\n',
    "",
  ),
  fault(
    "delayed-turns",
    "delayed left 90 stays in the junction",
    CONTROLLER,
    '"delayed left 90": [("move", 50), ("turn", -90), ("move", 60)]',
    '"delayed left 90": [("move", 50), ("turn", -90)]',
  ),
  fault(
    "delayed-wall",
    "a wall ends the whole delayed turn",
    CONTROLLER,
    "            self._phases.pop(0)\n",
    "            self._phases = [] if self._collided else self._phases[1:]\n",
  ),
  fault(
    "speed",
    "forward crawls",
    CONTROLLER,
    'SPEED if command["action"] == "forward"',
    'SPEED / 4 if command["action"] == "forward"',
  ),
  fault(
    "goal",
    "the goal is not stored",
    CONTROLLER,
    "self._goal_reached or self._body.at_goal",
    "self._body.at_goal",
  ),
];

const pose: InjectedFault[] = [
  fault(
    "pose-heading",
    "headings are counterclockwise",
    CONTROLLER,
    "round(pose.heading, 2) % 360",
    "round(-pose.heading, 2) % 360",
  ),
  fault(
    "pose-axes",
    "y grows upward",
    CONTROLLER,
    '"y": round(pose.y, 2)',
    '"y": -round(pose.y, 2)',
  ),
  fault(
    "pose-ending",
    "an ending tells no place",
    CONTROLLER,
    "return self._pose(), round(",
    'return {"x": 0, "y": 0, "heading": 0}, round(',
  ),
];

const stops: InjectedFault[] = [
  fault(
    "stop-overtakes",
    "a stop waits behind queued turns",
    COMMAND_STORE,
    "for entry in [self.running, *self._waiting]:\n            if entry is not None:",
    "for entry in [self.running]:\n            if entry is not None:",
  ),
  fault(
    "stop-overtakes",
    "a stop ends nothing",
    COMMAND_STORE,
    "        if is_stop:\n",
    "        if False:\n",
  ),
  fault(
    "stop-delete",
    "DELETE says nothing of its stop",
    SERVER,
    '"DELETE": lambda: self._submit(CommandRequest({"action": "stop"})),',
    '"DELETE": lambda: self._send(204, None),',
  ),
  {
    fault: "the wheels turn on after a stop",
    caughtBy: "stop-stands",
    edits: [
      {
        file: CONTROLLER,
        before: "        if self._entry is not store.running:\n            self._entry = None\n",
        after:
          "        if self._entry is not store.running:\n            self._last = self._entry\n            self._entry = None\n",
      },
      {
        file: CONTROLLER,
        before: "        moves = self._entry is not None\n",
        after: [
          "        last = getattr(self, '_last', None)",
          "        if self._entry is None and last and last.request.command['action'] == 'drive':",
          "            self._drive(*self._wheels_of(last.request.command), seconds)",
          "        moves = self._entry is not None\n",
        ].join("\n"),
      },
    ],
  },
  fault(
    "take-back-waiting",
    "what waits cannot be taken back",
    COMMAND_STORE,
    'if not entry.ended:\n            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)',
    'if entry is self.running:\n            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)',
  ),
  fault(
    "take-back-running",
    "what runs cannot be taken back",
    COMMAND_STORE,
    'if not entry.ended:\n            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)',
    'if entry in self._waiting:\n            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)',
  ),
  fault(
    "replace",
    "replace waits like any other command",
    COMMAND_STORE,
    "        elif request.replace:\n",
    "        elif False:\n",
  ),
  fault(
    "first-ending",
    "an ending is overwritten by a DELETE",
    COMMAND_STORE,
    'if not entry.ended:\n            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)',
    'if True:\n            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)',
  ),
];

const retries: InjectedFault[] = [
  fault(
    "retry",
    "keys are not stored",
    COMMAND_STORE,
    "None if key is None else self._by_key.get(key)",
    "None",
  ),
  fault(
    "retry",
    "another ttl makes another command",
    COMMAND_STORE,
    "before.request.command == request.command",
    "before.request.ttl == request.ttl",
  ),
  fault(
    "retry",
    "a retry with replace is another command",
    COMMAND_STORE,
    "before.request.command == request.command",
    "before.request.command == request.command and before.request.replace == request.replace",
  ),
  {
    fault: "two tries at the same moment are both taken",
    caughtBy: "retry-at-once",
    edits: [
      {
        file: SERVER,
        before: "            record = self.server.store.submit(request, key)\n",
        after: [
          "            known = key in self.server.store._by_key",
          "        if key and not known:",
          "            time.sleep(2.5)",
          "        with self.server.store.changed:",
          "            if key and not known:",
          "                self.server.store._by_key.pop(key, None)",
          "            record = self.server.store.submit(request, key)\n",
        ].join("\n"),
      },
    ],
  },
  fault(
    "no-key",
    "a record has a key that nobody sent",
    COMMAND_STORE,
    '"key": self.key,',
    '"key": self.key or "from-nobody",',
  ),
  fault(
    "key-conflict",
    "a key that was used hides another command",
    COMMAND_STORE,
    "before.request.command == request.command",
    "True",
  ),
  fault(
    "key-form",
    "any text is a key",
    SERVER,
    "if key is not None and _KEY.fullmatch(key) is None:",
    "if False:",
  ),
  fault(
    "key-form",
    "a key has at most 40 characters",
    SERVER,
    '_KEY = re.compile(r"[A-Za-z0-9_-]{8,64}")',
    '_KEY = re.compile(r"[A-Za-z0-9_-]{8,40}")',
  ),
  fault(
    "too-late",
    "what is too old on arrival is taken",
    COMMAND_STORE,
    "if request.age >= request.ttl:",
    "if False:",
  ),
  fault(
    "ttl",
    "a time to live ends nothing",
    COMMAND_STORE,
    "if entry.deadline <= now",
    "if False",
  ),
  fault(
    "age",
    "the age of a retry does not count",
    COMMAND_STORE,
    "(request.ttl - request.age) / 1_000",
    "request.ttl / 1_000",
  ),
  fault(
    "transit",
    "the time on the way does not count",
    SERVER,
    "request.age += self._transit",
    "pass",
  ),
  fault(
    "ttl-waits",
    "nothing may wait for longer than half a second",
    COMMAND_STORE,
    "(request.ttl - request.age) / 1_000",
    "min(500, request.ttl - request.age) / 1_000",
  ),
  fault(
    "ttl-default",
    "a command without a time to live waits for half a minute",
    COMMAND_REQUESTS,
    "DEFAULT_TTL = 10_000",
    "DEFAULT_TTL = 30_000",
  ),
  fault(
    "terms",
    "a lease may be 10 ms",
    COMMAND_REQUESTS,
    '"lease": (100, 2_000',
    '"lease": (10, 2_000',
  ),
  fault(
    "terms",
    "a time to live may be ten minutes",
    COMMAND_REQUESTS,
    '"ttl": (200, 60_000',
    '"ttl": (200, 600_000',
  ),
];

const life: InjectedFault[] = [
  fault(
    "accepted",
    "the answer does not say where the record is",
    SERVER,
    '{"Location": location}',
    "{}",
  ),
  fault(
    "numbers",
    "every other number is left out",
    COMMAND_STORE,
    "        self._entries.append(entry)\n",
    "        self._entries += [entry, entry]\n",
  ),
  fault(
    "actions",
    "short drives are refused",
    COMMAND_REQUESTS,
    '"milliseconds": (1, 60_000',
    '"milliseconds": (100, 60_000',
  ),
  fault(
    "record-command",
    "a record leaves out the milliseconds",
    COMMAND_STORE,
    '"command": self.request.command,',
    '"command": {k: v for k, v in self.request.command.items() if k != "milliseconds"},',
  ),
  fault(
    "order",
    "the newest command starts first",
    COMMAND_STORE,
    "self._waiting.popleft()",
    "self._waiting.pop()",
  ),
  fault(
    "record-wait",
    "a record that may wait waits for the ending",
    SERVER,
    "self._wait(query, lambda: entry.ended)",
    'self._wait({"wait": "25"} if "." in query.get("wait", "") else query, lambda: entry.ended)',
  ),
];

const reading: InjectedFault[] = [
  fault(
    "snapshot",
    "the robot says that it is paused",
    CONTROLLER,
    '"state": "running"',
    '"state": "paused"',
  ),
  fault(
    "snapshot-command",
    "a snapshot names the newest command while the robot stands",
    CONTROLLER,
    '"command": None if running is None else running.seq',
    '"command": len(self._store._entries) or None',
  ),
  fault(
    "reading-newer",
    "a robot that stands does not report",
    CONTROLLER,
    "REPORT_STANDING = 0.5",
    "REPORT_STANDING = 30",
  ),
  fault(
    "tick",
    "tick counts milliseconds",
    CONTROLLER,
    "self._up_since) * 60)",
    "self._up_since) * 1_000)",
  ),
  fault(
    "reading-wait",
    "a reading waits for the next snapshot, whatever was asked",
    SERVER,
    'self._wait(query, lambda: self.server.controller.snapshot["seq"] > after)',
    'self._wait({"wait": "12"}, lambda: self.server.controller.snapshot["seq"] > after)',
  ),
  fault(
    "maze",
    "the host has no maze and does not say so",
    HOST,
    '"maze": "It has no map of the room.",',
    "",
  ),
  fault(
    "log",
    "the log leaves out a record",
    COMMAND_STORE,
    "self._entries[after : after + LOG_PAGE]",
    "self._entries[after + 1 : after + LOG_PAGE]",
  ),
];

const events: InjectedFault[] = [
  fault(
    "stream",
    "states have another name in the stream",
    SERVER,
    'self._event("state", record, number)',
    'self._event("status", record, number)',
  ),
  {
    fault: "readers are flooded with snapshots",
    caughtBy: "stream-pace",
    edits: [
      { file: CONTROLLER, before: "STEP = 0.02", after: "STEP = 0.004" },
      { file: CONTROLLER, before: "REPORT_MOVING = 0.05", after: "REPORT_MOVING = 0" },
    ],
  },
  fault(
    "stream-resume",
    "Last-Event-ID is ignored",
    SERVER,
    'query.get("since") or self.headers.get("Last-Event-ID")',
    'query.get("since")',
  ),
  fault(
    "poll",
    "a poll brings one state and skips the others",
    SERVER,
    "for number, record in events],",
    "for number, record in events[:1]],",
  ),
  fault(
    "poll-snapshot",
    "a poll does not answer with a newer snapshot",
    SERVER,
    'return has_states or (after is not None and controller.snapshot["seq"] > after)',
    "return has_states",
  ),
  fault(
    "poll-once",
    "a poll brings the last state again",
    SERVER,
    '"since": f"{store.stream}-{newest}"',
    '"since": f"{store.stream}-{max(0, newest - 1)}"',
  ),
  fault(
    "resume",
    "numbers of events have holes",
    COMMAND_STORE,
    "self.newest_event += 1",
    "self.newest_event += 2",
  ),
  fault(
    "gap",
    "a reader of another stream is not told what it missed",
    SERVER,
    "(self.server.store.gap(), []) if n is None",
    "(None, []) if n is None",
  ),
  fault(
    "gap-stream",
    "a stream does not report its gap",
    SERVER,
    'self._event("gap", gap, n)',
    "pass",
  ),
];

const badInput: InjectedFault[] = [
  fault(
    "bad-command",
    "a refusal names no field",
    COMMAND_REQUESTS,
    '{"path": path, "found"',
    '{"path": "", "found"',
  ),
  fault(
    "bad-command",
    "power has no limit",
    COMMAND_REQUESTS,
    '"left": (-1, 1, "a wheel power")',
    '"left": (-9, 9, "a wheel power")',
  ),
  fault(
    "bad-command",
    "a field too many is ignored",
    COMMAND_REQUESTS,
    "if name not in allowed and name not in",
    "if False and name not in",
  ),
  fault(
    "body-size",
    "a body of 64 KiB is read",
    SERVER,
    "MAX_BYTES = 16 * 1024",
    "MAX_BYTES = 64 * 1024",
  ),
  fault(
    "body-type",
    "any body is taken for JSON",
    SERVER,
    'if kind != "application/json":',
    "if False:",
  ),
  fault(
    "bad-query",
    "a request may wait for 99 s",
    VALIDATION,
    "MAX_WAIT = 25.0",
    "MAX_WAIT = 99.0",
  ),
  fault(
    "no-command",
    "a command that there is not is a bad request",
    COMMAND_STORE,
    'Problem(404, "no-command"',
    'Problem(400, "no-command"',
  ),
  fault(
    "no-path",
    "an unknown method is an unknown path",
    SERVER,
    'raise method_not_allowed(self.command, ", ".join(calls))',
    "raise not_found()",
  ),
  fault(
    "bad-survived",
    "a refused command moves the robot",
    SERVER,
    "        request = parse_command(read_json(body))\n",
    [
      "        try:",
      "            request = parse_command(read_json(body))",
      "        except Problem:",
      "            with self.server.store.changed:",
      '                self.server.store.submit(CommandRequest({"action": "turn", "degrees": 50}), None)',
      "            raise\n",
    ].join("\n"),
  ),
];

const leases: InjectedFault[] = [
  fault(
    "silence",
    "forward runs for ever after its script fell silent",
    CONTROLLER,
    "SCRIPT_TIMEOUT = 3.0",
    "SCRIPT_TIMEOUT = 1e9",
  ),
  fault(
    "silence",
    "an open stream holds forward",
    SERVER,
    "                store.changed.wait_for(\n                    lambda: store.newest_event > n",
    "                store.last_contact = time.monotonic()\n                store.changed.wait_for(\n                    lambda: store.newest_event > n",
  ),
  fault(
    "silence-reverse",
    "reverse runs for ever",
    CONTROLLER,
    "is_connected = not is_drive and",
    'is_connected = command["action"] == "reverse" or not is_drive and',
  ),
  {
    fault: "reading does not hold forward",
    caughtBy: "renewed-by-reading",
    edits: [
      {
        file: SERVER,
        before: "        self.server.store.last_contact = time.monotonic()\n",
        after: "",
      },
      {
        file: SERVER,
        before:
          "                store.open_requests -= 1\n                store.last_contact = time.monotonic()\n",
        after: "                store.open_requests -= 1\n",
      },
    ],
  },
  fault(
    "renewed-by-waiting",
    "a request that waits does not hold reverse",
    CONTROLLER,
    "is_connected = not is_drive and self._store.open_requests > 0",
    "is_connected = False",
  ),
  fault(
    "drive-lease",
    "a drive lease of 5 s",
    CONTROLLER,
    "DRIVE_LEASE = 0.5",
    "DRIVE_LEASE = 5.0",
  ),
  fault(
    "drive-lease-asked",
    "the lease that a drive asks for is ignored",
    CONTROLLER,
    "(entry.request.lease or DRIVE_LEASE * 1_000)",
    "(DRIVE_LEASE * 1_000)",
  ),
  fault(
    "drive-not-renewed",
    "reading renews a drive",
    CONTROLLER,
    "since = self._started_at if is_drive else max(",
    "since = max(",
  ),
  fault(
    "drive-renewed",
    "a drive waits until the one before has ended",
    CONTROLLER,
    "        if self._store.has_waiting:\n",
    "        if self._store.has_waiting and not entry.request.lease:\n",
  ),
  {
    fault: "drives that wait run one after the other",
    caughtBy: "drive-newest",
    edits: [
      {
        file: CONTROLLER,
        before: "        if self._store.has_waiting:\n",
        after:
          '        if self._store.has_waiting and (entry.request.lease or command["action"] != "drive"):\n',
      },
      {
        file: COMMAND_STORE,
        before: "while len(self._waiting) > 1 and all(",
        after: "while False and all(",
      },
    ],
  },
  fault(
    "runs-to-end",
    "a drive with milliseconds ends with the silence of its script",
    CONTROLLER,
    "        if not _has_no_end(command):\n            return False\n",
    [
      "        if not _has_no_end(command):",
      "            heard = max(self._started_at, self._store.last_contact)",
      "            if self._store.open_requests > 0 or now - heard < SCRIPT_TIMEOUT:",
      "                return False",
      '            self._end(entry, "cancelled", "its script is silent")',
      "            return True\n",
    ].join("\n"),
  ),
  fault(
    "gives-way",
    "forward does not give way",
    CONTROLLER,
    "        if self._store.has_waiting:\n",
    '        if self._store.has_waiting and command["action"] == "drive":\n',
  ),
];

const limits: InjectedFault[] = [
  fault(
    "burst",
    "only 30 commands may wait",
    COMMAND_STORE,
    "MAX_WAITING = 64",
    "MAX_WAITING = 30",
  ),
  fault(
    "burst",
    "only 4 commands a second are taken",
    COMMAND_STORE,
    '        is_stop = request.command["action"] == "stop"\n',
    [
      '        is_stop = request.command["action"] == "stop"',
      "        now = self._clock()",
      '        room, at = getattr(self, "room", (40.0, now))',
      "        room = min(40.0, room + 4 * (now - at))",
      "        self.room = (room if is_stop else max(0.0, room - 1), now)",
      "        if room < 1 and not is_stop:",
      '            raise Problem(429, "queue-full", "Too fast.", headers={"Retry-After": "1"})\n',
    ].join("\n"),
  ),
  fault(
    "stop-burst",
    "a stop is refused while another one waits",
    COMMAND_STORE,
    '        is_stop = request.command["action"] == "stop"\n',
    [
      '        is_stop = request.command["action"] == "stop"',
      '        if is_stop and any(each.request.command["action"] == "stop" for each in self._waiting):',
      '            raise Problem(429, "queue-full", "One at a time.", headers={"Retry-After": "1"})\n',
    ].join("\n"),
  ),
  fault(
    "stop-full",
    "a stop is refused while the queue is full",
    COMMAND_STORE,
    "and not is_stop and not request.replace",
    "and not request.replace",
  ),
  fault(
    "queue",
    "only 50 commands may wait",
    COMMAND_STORE,
    "MAX_WAITING = 64",
    "MAX_WAITING = 50",
  ),
  fault(
    "log-page",
    "the log has pages of 1,000",
    COMMAND_STORE,
    "LOG_PAGE = 200",
    "LOG_PAGE = 1_000",
  ),
  fault(
    "events-kept",
    "only 100 events are kept",
    COMMAND_STORE,
    "MAX_EVENTS = 1_000",
    "MAX_EVENTS = 100",
  ),
];

const longPoll: InjectedFault[] = [
  fault(
    "long-poll-command",
    "states have the number of the next one",
    LONG_POLL,
    '{"type": "state", "n": n,',
    '{"type": "state", "n": n + 1,',
  ),
  fault(
    "long-poll-command",
    "the snapshot of an ending comes after it",
    LONG_POLL,
    "is_due = len(events) > 0 or now - connection.last_sent_at >= SNAPSHOT_INTERVAL",
    "is_due = len(events) == 0 and now - connection.last_sent_at >= SNAPSHOT_INTERVAL",
  ),
  {
    fault: "a key counts for its connection alone",
    caughtBy: "long-poll-retry",
    edits: [
      {
        file: LONG_POLL,
        before: "record = self._store.submit(request, key)",
        after: 'record = {**self._store.submit(request, f"{key}{connection.key}"), "key": key}',
      },
    ],
  },
  fault(
    "long-poll-resume",
    "`since` is ignored",
    LONG_POLL,
    'self._welcome(connection, hello.get("since"))',
    "self._welcome(connection, None)",
  ),
  fault(
    "long-poll-gap",
    "a reader receives no gap",
    LONG_POLL,
    '"snapshot": snapshot})\n        if gap is not None:',
    '"snapshot": snapshot})\n        if False:',
  ),
  fault(
    "long-poll-problem",
    "a refusal does not say of which command",
    LONG_POLL,
    '"problem": problem.document, "key": key}',
    '"problem": problem.document, "key": None}',
  ),
  fault(
    "long-poll-transit",
    "the time on the way does not count",
    LONG_POLL,
    "request.age += connection.transit(message)",
    "connection.transit(message)",
  ),
  fault(
    "long-poll-key",
    "any key that looks like one opens a connection",
    LONG_POLL,
    "not hmac.compare_digest(key.encode(), self._key.encode())",
    "not key.startswith(self._key[:8])",
  ),
  fault(
    "long-poll-key",
    "every version of the protocol is welcome",
    LONG_POLL,
    'if hello.get("version") != VERSION:',
    "if False:",
  ),
  fault(
    "long-poll-silence",
    "an open connection holds a motion",
    LONG_POLL,
    "self._connections.append(connection)",
    "self._connections.append(connection)\n            self._store.open_requests += 1",
  ),
  fault(
    "long-poll-numbers",
    "messages that are posted again are taken again",
    LONG_POLL,
    "if number == connection.received + 1:",
    "if True:",
  ),
  fault(
    "long-poll-numbers",
    "messages are deleted before they are confirmed",
    LONG_POLL,
    '            messages = connection.outbox[:MAX_MESSAGES]\n            return {"first": connection.first, "messages": messages, "closed": None}',
    [
      "            first, sent = connection.first, connection.outbox",
      "            connection.first, connection.outbox = first + len(sent), []",
      '            return {"first": first, "messages": sent, "closed": None}',
    ].join("\n"),
  ),
];

/**
 * Appends the number of the connection to a key, so that the host receives another key in each
 * connection.
 */
function keyOfConnection(message: Message, connection: number): Message {
  const { type, key } = message;
  return type === "command" ? { ...message, key: `${key}-${connection}` } : message;
}

function keyOfScript(message: Message, connection: number): Message {
  const { record } = message;
  if (record === undefined) return message;
  const key = record.key?.replace(new RegExp(`-${connection}$`), "") ?? null;
  return { ...message, record: { ...record, key } };
}

function bridged(caughtBy: string, what: string, bridge: BridgeFault): InjectedFault {
  return { fault: what, caughtBy, edits: [], bridge };
}

const webSocket: InjectedFault[] = [
  bridged("websocket-command", "states have the number of the next one", {
    toScript: (message) =>
      message.type === "state" ? { ...message, n: (message.n ?? 0) + 1 } : message,
  }),
  bridged("websocket-command", "no snapshot is sent", {
    toScript: (message) => (message.type === "snapshot" ? null : message),
  }),
  bridged("websocket-retry", "a key counts for its connection alone", {
    toHost: keyOfConnection,
    toScript: keyOfScript,
  }),
  bridged("websocket-resume", "`since` is ignored", {
    toHost: ({ since: _since, ...message }) => message as Message,
  }),
  bridged("websocket-gap", "a reader receives no gap", {
    toScript: (message) => (message.type === "gap" ? null : message),
  }),
  bridged("websocket-problem", "a refusal does not say of which command", {
    toScript: (message) => (message.type === "problem" ? { ...message, key: null } : message),
  }),
  bridged("websocket-transit", "the time on the way does not count", {
    toHost: ({ sentAt: _sentAt, ...message }) => message as Message,
  }),
  bridged("websocket-key", "a wrong key closes the connection by another code", {
    closeCode: 1008,
  }),
  bridged("websocket-key", "every version of the protocol is welcome", { takesAnyVersion: true }),
  bridged("websocket-silence", "an open connection holds a motion", { isRestless: true }),
];

export const injectedFaults: readonly InjectedFault[] = [
  ...access,
  ...directions,
  ...pose,
  ...stops,
  ...retries,
  ...events,
  ...life,
  ...reading,
  ...badInput,
  ...leases,
  ...limits,
  ...longPoll,
  ...webSocket,
  ...messageFlow,
];
