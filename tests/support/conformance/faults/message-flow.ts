/** Faults in sizes, rates and keys of messages. */
import { LONG_POLL, SERVER, bridgeFault, fault, type InjectedFault } from "../injected-fault.ts";

export const messageFlowFaults: readonly InjectedFault[] = [
  fault(
    "long-poll-size",
    "a large request of a connection is accepted",
    SERVER,
    "if len(body) > MAX_BYTES:",
    'if len(body) > MAX_BYTES and "/long-poll" not in self.path:',
  ),
  fault(
    "long-poll-key-wrong",
    "any connection key can read",
    LONG_POLL,
    "if hmac.compare_digest(key.encode(), connection.key.encode()):",
    "if key[:4] == connection.key[:4]:",
  ),
  fault(
    "long-poll-pace",
    "a connection receives too many snapshots",
    LONG_POLL,
    'connection.outbox.append({"type": "snapshot", "snapshot": snapshot})',
    'connection.outbox += [{"type": "snapshot", "snapshot": snapshot}] * 4',
  ),
  bridgeFault("websocket-size", "a message of 8 KiB is too large", { maxBytes: 8 * 1024 }),
  bridgeFault("websocket-size", "a message of 32 KiB is accepted", { maxBytes: 32 * 1024 }),
  bridgeFault("websocket-seen", "snapshots are sent without an acknowledgement", {
    ignoresSeen: true,
  }),
  bridgeFault("websocket-seen", "an acknowledgement has no effect", {
    toHost: (message) => (message.type === "seen" ? { ...message, seq: 0 } : message),
  }),
  bridgeFault("websocket-heartbeat", "no heartbeat is sent", {
    toScript: (message) => (message.type === "heartbeat" ? null : message),
  }),
];
