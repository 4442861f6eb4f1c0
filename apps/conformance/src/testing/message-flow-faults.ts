/** Faults in the keys, sizes and rates of messages. */
import type { InjectedFault } from "./injected-fault.ts";

const SERVER = "physical_robot/server.py";
const LONG_POLL = "physical_robot/long_poll.py";
const COMMAND_STORE = "physical_robot/command_store.py";

export const messageFlow: readonly InjectedFault[] = [
  {
    fault: "any key reads",
    caughtBy: "key-wrong-reading",
    edits: [
      {
        file: SERVER,
        before: "if key is None or not hmac",
        after: 'if key is None or self.command != "GET" and not hmac',
      },
    ],
  },
  {
    fault: "each drive of a burst runs for a moment",
    caughtBy: "drive-burst",
    edits: [
      {
        file: COMMAND_STORE,
        before: "while len(self._waiting) > 1 and all(",
        after: "while False and all(",
      },
    ],
  },
  {
    fault: "only the newest 200 records are retained",
    caughtBy: "records-retained",
    edits: [
      {
        file: COMMAND_STORE,
        before: "if 1 <= seq <= len(self._entries):",
        after: "if max(1, len(self._entries) - 199) <= seq <= len(self._entries):",
      },
    ],
  },
  {
    fault: "a large request of a connection is accepted",
    caughtBy: "long-poll-size",
    edits: [
      {
        file: SERVER,
        before: "if len(body) > MAX_BYTES:",
        after: 'if len(body) > MAX_BYTES and "/long-poll" not in self.path:',
      },
    ],
  },
  {
    fault: "any key of a connection reads",
    caughtBy: "long-poll-key-wrong",
    edits: [
      {
        file: LONG_POLL,
        before: "if hmac.compare_digest(key.encode(), connection.key.encode()):",
        after: "if key[:4] == connection.key[:4]:",
      },
    ],
  },
  {
    fault: "a connection is flooded with snapshots",
    caughtBy: "long-poll-pace",
    edits: [
      {
        file: LONG_POLL,
        before: 'connection.outbox.append({"type": "snapshot", "snapshot": snapshot})',
        after: 'connection.outbox += [{"type": "snapshot", "snapshot": snapshot}] * 4',
      },
    ],
  },
  {
    fault: "a message of 8 KiB is too large",
    caughtBy: "websocket-size",
    edits: [],
    bridge: { maxBytes: 8 * 1024 },
  },
  {
    fault: "a message of 32 KiB is accepted",
    caughtBy: "websocket-size",
    edits: [],
    bridge: { maxBytes: 32 * 1024 },
  },
  {
    fault: "snapshots are sent without an acknowledgement",
    caughtBy: "websocket-seen",
    edits: [],
    bridge: { ignoresSeen: true },
  },
  {
    fault: "an acknowledgement changes nothing",
    caughtBy: "websocket-seen",
    edits: [],
    bridge: {
      toHost: (message) => (message.type === "seen" ? { ...message, seq: 0 } : message),
    },
  },
  {
    fault: "no heartbeat is sent",
    caughtBy: "websocket-heartbeat",
    edits: [],
    bridge: { toScript: (message) => (message.type === "heartbeat" ? null : message) },
  },
];
