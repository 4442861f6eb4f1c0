/** Faults in events. */
import { COMMAND_STORE, CONTROLLER, SERVER, fault, type InjectedFault } from "../injected-fault.ts";

export const eventsFaults: readonly InjectedFault[] = [
  fault(
    "stream",
    "the stream has another event name for states",
    SERVER,
    'self._event("state", record, number)',
    'self._event("status", record, number)',
  ),
  {
    fault: "readers receive too many snapshots",
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
    "a poll contains one state and skips the others",
    SERVER,
    "for number, record in events],",
    "for number, record in events[:1]],",
  ),
  fault(
    "poll-snapshot",
    "a poll does not respond to a newer snapshot",
    SERVER,
    'return has_states or (after is not None and controller.snapshot["seq"] > after)',
    "return has_states",
  ),
  fault(
    "poll-once",
    "a poll contains the last state again",
    SERVER,
    '"since": f"{store.stream}-{newest}"',
    '"since": f"{store.stream}-{max(0, newest - 1)}"',
  ),
  fault(
    "resume",
    "events skip numbers",
    COMMAND_STORE,
    "self.newest_event += 1",
    "self.newest_event += 2",
  ),
  fault(
    "gap",
    "a reader of another stream receives no gap",
    SERVER,
    "(self.server.store.gap(), []) if n is None",
    "(None, []) if n is None",
  ),
  fault(
    "gap-stream",
    "a stream does not start with its gap",
    SERVER,
    'self._event("gap", gap, n)',
    "pass",
  ),
];
