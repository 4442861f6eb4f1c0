/** Faults in the WebSocket. */
import { bridgeFault, type InjectedFault } from "../injected-fault.ts";
import type { Message } from "../websocket-bridge.ts";

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

export const webSocketFaults: readonly InjectedFault[] = [
  bridgeFault("websocket-command", "states have the number of the next one", {
    toScript: (message) =>
      message.type === "state" ? { ...message, n: (message.n ?? 0) + 1 } : message,
  }),
  bridgeFault("websocket-command", "no snapshot is sent", {
    toScript: (message) => (message.type === "snapshot" ? null : message),
  }),
  bridgeFault("websocket-retry", "an idempotency key is only valid in its connection", {
    toHost: keyOfConnection,
    toScript: keyOfScript,
  }),
  bridgeFault("websocket-resume", "`since` is ignored", {
    toHost: ({ since: _since, ...message }) => message as Message,
  }),
  bridgeFault("websocket-gap", "a reader receives no gap", {
    toScript: (message) => (message.type === "gap" ? null : message),
  }),
  bridgeFault("websocket-problem", "a problem does not contain the key of its command", {
    toScript: (message) => (message.type === "problem" ? { ...message, key: null } : message),
  }),
  bridgeFault("websocket-transit", "transit time is ignored", {
    toHost: ({ sentAt: _sentAt, ...message }) => message as Message,
  }),
  bridgeFault("websocket-key", "a wrong key closes the connection with another code", {
    closeCode: 1008,
  }),
  bridgeFault("websocket-key", "every version of the protocol is accepted", {
    acceptsAnyVersion: true,
  }),
  bridgeFault("websocket-silence", "an open connection renews a motion", { pollsHost: true }),
];
