/** Faults in the long-poll connection. */
import { LONG_POLL, fault, type InjectedFault } from "../injected-fault.ts";

export const longPollFaults: readonly InjectedFault[] = [
  fault(
    "long-poll-command",
    "states have the number of the next one",
    LONG_POLL,
    '{"type": "state", "n": n,',
    '{"type": "state", "n": n + 1,',
  ),
  fault(
    "long-poll-command",
    "the snapshot of a final state is sent after that state",
    LONG_POLL,
    "is_due = len(events) > 0 or now - connection.last_sent_at >= SNAPSHOT_INTERVAL",
    "is_due = len(events) == 0 and now - connection.last_sent_at >= SNAPSHOT_INTERVAL",
  ),
  fault(
    "long-poll-retry",
    "an idempotency key is only valid in its connection",
    LONG_POLL,
    "record = self._store.submit(request, key)",
    'record = {**self._store.submit(request, f"{key}{connection.key}"), "key": key}',
  ),
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
    "a problem does not contain the key of its command",
    LONG_POLL,
    '"problem": problem.document, "key": key}',
    '"problem": problem.document, "key": None}',
  ),
  fault(
    "long-poll-transit",
    "transit time is ignored",
    LONG_POLL,
    "request.age += connection.transit(message)",
    "connection.transit(message)",
  ),
  fault(
    "long-poll-key",
    "a wrong key of the same form opens a connection",
    LONG_POLL,
    "not hmac.compare_digest(key.encode(), self._key.encode())",
    "not key.startswith(self._key[:8])",
  ),
  fault(
    "long-poll-key",
    "every version of the protocol is accepted",
    LONG_POLL,
    'if hello.get("version") != VERSION:',
    "if False:",
  ),
  fault(
    "long-poll-silence",
    "an open connection renews a motion",
    LONG_POLL,
    "self._connections.append(connection)",
    "self._connections.append(connection)\n            self._store.open_requests += 1",
  ),
  fault(
    "long-poll-numbers",
    "repeated messages are processed twice",
    LONG_POLL,
    "if number == connection.received + 1:",
    "if True:",
  ),
  fault(
    "long-poll-numbers",
    "messages are deleted before they are acknowledged",
    LONG_POLL,
    '            messages = connection.outbox[:MAX_MESSAGES]\n            return {"first": connection.first, "messages": messages, "closed": None}',
    [
      "            first, sent = connection.first, connection.outbox",
      "            connection.first, connection.outbox = first + len(sent), []",
      '            return {"first": first, "messages": sent, "closed": None}',
    ].join("\n"),
  ),
];
