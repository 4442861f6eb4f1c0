/**
 * Faults for the example of a physical robot: what is wrong, the text of its Python source that makes
 * it so, and the promise whose check is the first to fail.
 */
import type { Edit } from "./physical-robot.ts";
import type { BridgeFault, Message } from "./websocket-bridge.ts";

export interface PlantedFault {
  fault: string;
  edits: readonly Edit[];
  caughtBy: string;
  /** for a WebSocket, which the example has by a bridge alone */
  bridge?: BridgeFault;
}

const BODY = "physical_robot/body.py";
const HOST = "robot_host.py";
const LEDGER = "physical_robot/ledger.py";
const LINES = "physical_robot/lines.py";
const ORDERS = "physical_robot/orders.py";
const PILOT = "physical_robot/pilot.py";
const READING = "physical_robot/reading.py";
const SERVER = "physical_robot/server.py";

/** A fault that is one replaced text. */
function fault(caughtBy: string, what: string, file: string, before: string, after: string) {
  return { fault: what, caughtBy, edits: [{ file, before, after }] };
}

const access: PlantedFault[] = [
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

const directions: PlantedFault[] = [
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
        file: PILOT,
        before: "        self._report()\n        return self._pose()",
        after: "        return self._pose()",
      },
      { file: PILOT, before: "REPORT_MOVING = 0.05", after: "REPORT_MOVING = 0.5" },
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
    PILOT,
    '"left 90": [("turn", -90)]',
    '"left 90": [("turn", 90)]',
  ),
  fault(
    "turn-right",
    "right 90 turns left",
    PILOT,
    '"right 90": [("turn", 90)]',
    '"right 90": [("turn", -90)]',
  ),
  fault("turn-half", "turn 180 turns a quarter", PILOT, '("turn", 180)', '("turn", 90)'),
  fault(
    "turn-whole",
    "right 90 turns by 80 degrees",
    PILOT,
    '"right 90": [("turn", 90)]',
    '"right 90": [("turn", 80)]',
  ),
  fault(
    "turn-degrees",
    "degrees count to the left",
    PILOT,
    '("turn", command["degrees"])',
    '("turn", -command["degrees"])',
  ),
  fault(
    "move-distance",
    "move drives half the distance",
    PILOT,
    '("move", command["distance"])',
    '("move", command["distance"] / 2)',
  ),
  fault(
    "move-backward",
    "a move below 0 drives ahead",
    PILOT,
    '("move", command["distance"])',
    '("move", abs(command["distance"]))',
  ),
  fault(
    "record-distance",
    "a record tells half of the way",
    PILOT,
    "round(self._distance, 2)",
    "round(self._distance / 2, 2)",
  ),
  fault(
    "milliseconds",
    "drive lasts for half of its milliseconds",
    PILOT,
    'command["milliseconds"] / 1_000',
    'command["milliseconds"] / 2_000',
  ),
  fault(
    "wheels",
    "the wheels are swapped",
    PILOT,
    'command["left"] * WHEEL_SPEED, command["right"] * WHEEL_SPEED',
    'command["right"] * WHEEL_SPEED, command["left"] * WHEEL_SPEED',
  ),
  fault(
    "forward-reverse",
    "reverse drives ahead",
    PILOT,
    'SPEED if command["action"] == "forward" else -SPEED',
    "SPEED",
  ),
  fault(
    "collision",
    "a move that met a wall counts as completed",
    PILOT,
    "self._collided = True",
    "self._collided = False",
  ),
  fault("collision", "one contact counts as two bumps", BODY, "self.bumps += 1", "self.bumps += 2"),
  fault(
    "collision-forward",
    "forward pushes against the wall",
    PILOT,
    '            if self._body.bumping:\n                self._end(entry, "collided")\n',
    "",
  ),
  fault(
    "delayed-turns",
    "delayed left 90 stays in the junction",
    PILOT,
    '"delayed left 90": [("move", 50), ("turn", -90), ("move", 60)]',
    '"delayed left 90": [("move", 50), ("turn", -90)]',
  ),
  fault(
    "delayed-wall",
    "a wall ends the whole delayed turn",
    PILOT,
    "            self._parts.pop(0)\n",
    "            self._parts = [] if self._collided else self._parts[1:]\n",
  ),
  fault(
    "speed",
    "forward crawls",
    PILOT,
    'SPEED if command["action"] == "forward"',
    'SPEED / 4 if command["action"] == "forward"',
  ),
  fault(
    "goal",
    "the goal is forgotten",
    PILOT,
    "self._goal_reached or self._body.at_goal",
    "self._body.at_goal",
  ),
];

const pose: PlantedFault[] = [
  fault(
    "pose-heading",
    "headings are counterclockwise",
    PILOT,
    "round(pose.heading, 2) % 360",
    "round(-pose.heading, 2) % 360",
  ),
  fault("pose-axes", "y grows upward", PILOT, '"y": round(pose.y, 2)', '"y": -round(pose.y, 2)'),
  fault(
    "pose-ending",
    "an ending tells no place",
    PILOT,
    "return self._pose(), round(",
    'return {"x": 0, "y": 0, "heading": 0}, round(',
  ),
];

const stops: PlantedFault[] = [
  fault(
    "stop-overtakes",
    "a stop waits behind queued turns",
    LEDGER,
    "for entry in [self.running, *self._waiting]:\n            if entry is not None:",
    "for entry in [self.running]:\n            if entry is not None:",
  ),
  fault(
    "stop-overtakes",
    "a stop ends nothing",
    LEDGER,
    "        if is_stop:\n",
    "        if False:\n",
  ),
  fault(
    "stop-delete",
    "DELETE says nothing of its stop",
    SERVER,
    '"DELETE": lambda: self._submit(Order({"action": "stop"})),',
    '"DELETE": lambda: self._send(204, None),',
  ),
  {
    fault: "the wheels turn on after a stop",
    caughtBy: "stop-stands",
    edits: [
      {
        file: PILOT,
        before: "        if self._entry is not ledger.running:\n            self._entry = None\n",
        after:
          "        if self._entry is not ledger.running:\n            self._last = self._entry\n            self._entry = None\n",
      },
      {
        file: PILOT,
        before: "        moves = self._entry is not None\n",
        after: [
          "        last = getattr(self, '_last', None)",
          "        if self._entry is None and last and last.order.command['action'] == 'drive':",
          "            self._drive(*self._wheels_of(last.order.command), seconds)",
          "        moves = self._entry is not None\n",
        ].join("\n"),
      },
    ],
  },
  fault(
    "take-back-waiting",
    "what waits cannot be taken back",
    LEDGER,
    'if not entry.ended:\n            self.end(entry, "cancelled", TAKEN_BACK)',
    'if entry is self.running:\n            self.end(entry, "cancelled", TAKEN_BACK)',
  ),
  fault(
    "take-back-running",
    "what runs cannot be taken back",
    LEDGER,
    'if not entry.ended:\n            self.end(entry, "cancelled", TAKEN_BACK)',
    'if entry in self._waiting:\n            self.end(entry, "cancelled", TAKEN_BACK)',
  ),
  fault(
    "replace",
    "replace waits like any other command",
    LEDGER,
    "        elif order.replace:\n",
    "        elif False:\n",
  ),
  fault(
    "first-ending",
    "an ending is overwritten by a DELETE",
    LEDGER,
    'if not entry.ended:\n            self.end(entry, "cancelled", TAKEN_BACK)',
    'if True:\n            self.end(entry, "cancelled", TAKEN_BACK)',
  ),
];

const retries: PlantedFault[] = [
  fault(
    "retry",
    "keys are forgotten",
    LEDGER,
    "None if key is None else self._by_key.get(key)",
    "None",
  ),
  fault(
    "retry",
    "another ttl makes another command",
    LEDGER,
    "before.order.command == order.command",
    "before.order.ttl == order.ttl",
  ),
  {
    fault: "two tries at the same moment are both taken",
    caughtBy: "retry-at-once",
    edits: [
      {
        file: SERVER,
        before: "            record = self.server.ledger.submit(order, key)\n",
        after: [
          "            known = key in self.server.ledger._by_key",
          "        if key and not known:",
          "            time.sleep(2.5)",
          "        with self.server.ledger.changed:",
          "            if key and not known:",
          "                self.server.ledger._by_key.pop(key, None)",
          "            record = self.server.ledger.submit(order, key)\n",
        ].join("\n"),
      },
    ],
  },
  fault(
    "no-key",
    "a record has a key that nobody sent",
    LEDGER,
    '"key": self.key,',
    '"key": self.key or "from-nobody",',
  ),
  fault(
    "key-conflict",
    "a key that was used hides another command",
    LEDGER,
    "before.order.command == order.command",
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
    "too-late",
    "what is too old on arrival is taken",
    LEDGER,
    "if order.age >= order.ttl:",
    "if False:",
  ),
  fault("ttl", "a time to live ends nothing", LEDGER, "if entry.deadline <= now", "if False"),
  fault(
    "age",
    "the age of a retry does not count",
    LEDGER,
    "(order.ttl - order.age) / 1_000",
    "order.ttl / 1_000",
  ),
  fault(
    "transit",
    "the time on the way does not count",
    SERVER,
    "order.age += self._transit",
    "pass",
  ),
  fault(
    "ttl-waits",
    "nothing may wait for longer than half a second",
    LEDGER,
    "(order.ttl - order.age) / 1_000",
    "min(500, order.ttl - order.age) / 1_000",
  ),
  fault(
    "terms",
    "a time to live may be ten minutes",
    ORDERS,
    '"ttl": (200, 60_000',
    '"ttl": (200, 600_000',
  ),
];

const life: PlantedFault[] = [
  fault(
    "accepted",
    "the answer does not say where the record is",
    SERVER,
    '{"Location": place}',
    "{}",
  ),
  fault(
    "numbers",
    "every other number is left out",
    LEDGER,
    "        self._entries.append(entry)\n",
    "        self._entries += [entry, entry]\n",
  ),
  fault(
    "actions",
    "short drives are refused",
    ORDERS,
    '"milliseconds": (1, 60_000',
    '"milliseconds": (100, 60_000',
  ),
  fault(
    "record-command",
    "a record leaves out the milliseconds",
    LEDGER,
    '"command": self.order.command,',
    '"command": {k: v for k, v in self.order.command.items() if k != "milliseconds"},',
  ),
  fault(
    "order",
    "the newest command starts first",
    LEDGER,
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

const reading: PlantedFault[] = [
  fault(
    "snapshot",
    "the robot says that it is paused",
    PILOT,
    '"state": "running"',
    '"state": "paused"',
  ),
  fault(
    "snapshot-command",
    "a snapshot names the newest command while the robot stands",
    PILOT,
    '"command": None if running is None else running.seq',
    '"command": len(self._ledger._entries) or None',
  ),
  fault(
    "reading-newer",
    "a robot that stands does not report",
    PILOT,
    "REPORT_STANDING = 0.5",
    "REPORT_STANDING = 30",
  ),
  fault(
    "tick",
    "tick counts milliseconds",
    PILOT,
    "self._up_since) * 60)",
    "self._up_since) * 1_000)",
  ),
  fault(
    "reading-wait",
    "a reading waits for the next snapshot, whatever was asked",
    SERVER,
    'self._wait(query, lambda: self.server.pilot.snapshot["seq"] > after)',
    'self._wait({"wait": "12"}, lambda: self.server.pilot.snapshot["seq"] > after)',
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
    LEDGER,
    "self._entries[after : after + LOG_PAGE]",
    "self._entries[after + 1 : after + LOG_PAGE]",
  ),
];

const events: PlantedFault[] = [
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
      { file: PILOT, before: "STEP = 0.02", after: "STEP = 0.004" },
      { file: PILOT, before: "REPORT_MOVING = 0.05", after: "REPORT_MOVING = 0" },
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
    "poll-once",
    "a poll brings the last state again",
    SERVER,
    '"since": f"{ledger.stream}-{newest}"',
    '"since": f"{ledger.stream}-{max(0, newest - 1)}"',
  ),
  fault(
    "resume",
    "numbers of events have holes",
    LEDGER,
    "self.newest_event += 1",
    "self.newest_event += 2",
  ),
  fault(
    "gap",
    "a reader of another stream is not told what it missed",
    SERVER,
    "(self.server.ledger.gap(), []) if n is None",
    "(None, []) if n is None",
  ),
  fault(
    "gap-stream",
    "a stream does not tell its gap",
    SERVER,
    'self._event("gap", gap, n)',
    "pass",
  ),
];

const badInput: PlantedFault[] = [
  fault(
    "bad-command",
    "a refusal names no field",
    ORDERS,
    '{"path": path, "found"',
    '{"path": "", "found"',
  ),
  fault(
    "bad-command",
    "power has no limit",
    ORDERS,
    '"left": (-1, 1, "a wheel power")',
    '"left": (-9, 9, "a wheel power")',
  ),
  fault(
    "bad-command",
    "a field too many is ignored",
    ORDERS,
    "if name not in allowed and name not in",
    "if False and name not in",
  ),
  fault(
    "body-size",
    "a body of 64 KiB is read",
    SERVER,
    "MOST_BYTES = 16 * 1024",
    "MOST_BYTES = 64 * 1024",
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
    READING,
    "LONGEST_WAIT = 25.0",
    "LONGEST_WAIT = 99.0",
  ),
  fault(
    "no-command",
    "a command that there is not is a bad request",
    LEDGER,
    'Problem(404, "no-command"',
    'Problem(400, "no-command"',
  ),
  fault(
    "no-path",
    "an unknown method is an unknown path",
    SERVER,
    'raise not_known(self.command, ", ".join(calls))',
    "raise nothing_here()",
  ),
  fault(
    "bad-survived",
    "a refused command moves the robot",
    SERVER,
    "        order = order_of(read_json(body))\n",
    [
      "        try:",
      "            order = order_of(read_json(body))",
      "        except Problem:",
      "            with self.server.ledger.changed:",
      '                self.server.ledger.submit(Order({"action": "turn", "degrees": 50}), None)',
      "            raise\n",
    ].join("\n"),
  ),
];

const leases: PlantedFault[] = [
  fault(
    "silence",
    "forward runs for ever after its script fell silent",
    PILOT,
    "SILENCE = 3.0",
    "SILENCE = 1e9",
  ),
  fault(
    "silence",
    "an open stream holds forward",
    SERVER,
    "                ledger.changed.wait_for(\n                    lambda: ledger.newest_event > n",
    "                ledger.heard_at = time.monotonic()\n                ledger.changed.wait_for(\n                    lambda: ledger.newest_event > n",
  ),
  fault(
    "silence-reverse",
    "reverse runs for ever",
    PILOT,
    "is_heard = not is_drive and",
    'is_heard = command["action"] == "reverse" or not is_drive and',
  ),
  {
    fault: "reading does not hold forward",
    caughtBy: "renewed-by-reading",
    edits: [
      {
        file: SERVER,
        before: "        self.server.ledger.heard_at = time.monotonic()\n",
        after: "",
      },
      {
        file: SERVER,
        before:
          "                ledger.listeners -= 1\n                ledger.heard_at = time.monotonic()\n",
        after: "                ledger.listeners -= 1\n",
      },
    ],
  },
  fault(
    "renewed-by-waiting",
    "a request that waits does not hold reverse",
    PILOT,
    "is_heard = not is_drive and self._ledger.listeners > 0",
    "is_heard = False",
  ),
  fault("drive-lease", "a drive lease of 5 s", PILOT, "DRIVE_LEASE = 0.5", "DRIVE_LEASE = 5.0"),
  fault(
    "drive-lease-asked",
    "the lease that a drive asks for is ignored",
    PILOT,
    "(entry.order.lease or DRIVE_LEASE * 1_000)",
    "(DRIVE_LEASE * 1_000)",
  ),
  fault(
    "drive-not-renewed",
    "reading renews a drive",
    PILOT,
    "since = self._began if is_drive else max(",
    "since = max(",
  ),
  fault(
    "drive-renewed",
    "a drive waits until the one before has ended",
    PILOT,
    "        if self._ledger.has_waiting:\n",
    "        if self._ledger.has_waiting and not entry.order.lease:\n",
  ),
  fault(
    "drive-newest",
    "drives that wait run one after the other",
    PILOT,
    "        if self._ledger.has_waiting:\n",
    '        if self._ledger.has_waiting and (entry.order.lease or command["action"] != "drive"):\n',
  ),
  fault(
    "runs-to-end",
    "a drive with milliseconds ends with the silence of its script",
    PILOT,
    "        if not _has_no_end(command):\n            return False\n",
    [
      "        if not _has_no_end(command):",
      "            heard = max(self._began, self._ledger.heard_at)",
      "            if self._ledger.listeners > 0 or now - heard < SILENCE:",
      "                return False",
      '            self._end(entry, "cancelled", "its script is silent")',
      "            return True\n",
    ].join("\n"),
  ),
  fault(
    "gives-way",
    "forward does not give way",
    PILOT,
    "        if self._ledger.has_waiting:\n",
    '        if self._ledger.has_waiting and command["action"] == "drive":\n',
  ),
];

const limits: PlantedFault[] = [
  fault("burst", "only 30 commands may wait", LEDGER, "MOST_WAITING = 64", "MOST_WAITING = 30"),
  fault(
    "stop-full",
    "a stop is refused while the queue is full",
    LEDGER,
    "and not is_stop and not order.replace",
    "and not order.replace",
  ),
  fault("queue", "only 50 commands may wait", LEDGER, "MOST_WAITING = 64", "MOST_WAITING = 50"),
  fault("log-page", "the log has pages of 1,000", LEDGER, "LOG_PAGE = 200", "LOG_PAGE = 1_000"),
  fault(
    "events-kept",
    "only 100 events are kept",
    LEDGER,
    "KEPT_EVENTS = 1_000",
    "KEPT_EVENTS = 100",
  ),
];

const longPoll: PlantedFault[] = [
  fault(
    "long-poll-command",
    "states have the number of the next one",
    LINES,
    '{"type": "state", "n": n,',
    '{"type": "state", "n": n + 1,',
  ),
  fault(
    "long-poll-command",
    "the snapshot of an ending comes after it",
    LINES,
    "is_due = len(events) > 0 or now - line.told_at >= PACE",
    "is_due = len(events) == 0 and now - line.told_at >= PACE",
  ),
  {
    fault: "a key counts for its connection alone",
    caughtBy: "long-poll-retry",
    edits: [
      {
        file: LINES,
        before: "record = self._ledger.submit(order, key)",
        after: 'record = {**self._ledger.submit(order, f"{key}{line.key}"), "key": key}',
      },
    ],
  },
  fault(
    "long-poll-resume",
    "`since` is ignored",
    LINES,
    'self._welcome(line, hello.get("since"))',
    "self._welcome(line, None)",
  ),
  fault(
    "long-poll-gap",
    "a reader receives no gap",
    LINES,
    '"snapshot": snapshot})\n        if gap is not None:',
    '"snapshot": snapshot})\n        if False:',
  ),
  fault(
    "long-poll-problem",
    "a refusal does not say of which command",
    LINES,
    '"problem": problem.document, "key": key}',
    '"problem": problem.document, "key": None}',
  ),
  fault(
    "long-poll-transit",
    "the time on the way does not count",
    LINES,
    "order.age += line.transit(message)",
    "line.transit(message)",
  ),
  fault(
    "long-poll-key",
    "any key that looks like one opens a connection",
    LINES,
    "not hmac.compare_digest(key.encode(), self._key.encode())",
    "not key.startswith(self._key[:8])",
  ),
  fault(
    "long-poll-key",
    "every version of the protocol is welcome",
    LINES,
    'if hello.get("version") != VERSION:',
    "if False:",
  ),
  fault(
    "long-poll-silence",
    "an open connection holds a motion",
    LINES,
    "self._lines.append(line)",
    "self._lines.append(line)\n            self._ledger.listeners += 1",
  ),
  fault(
    "long-poll-numbers",
    "messages that are posted again are taken again",
    LINES,
    "if number == line.taken + 1:",
    "if True:",
  ),
  fault(
    "long-poll-numbers",
    "messages are forgotten before they are confirmed",
    LINES,
    '            return {"first": line.first, "messages": line.outbox[:MOST_MESSAGES], "closed": None}',
    [
      "            first, sent = line.first, line.outbox",
      "            line.first, line.outbox = first + len(sent), []",
      '            return {"first": first, "messages": sent, "closed": None}',
    ].join("\n"),
  ),
];

/** The same text for a key at both ends of one connection, and another one at the next. */
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

function bridged(caughtBy: string, what: string, bridge: BridgeFault): PlantedFault {
  return { fault: what, caughtBy, edits: [], bridge };
}

const webSocket: PlantedFault[] = [
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

export const plantedFaults: readonly PlantedFault[] = [
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
];
