/** Faults in limits. */
import { COMMAND_STORE, fault, type InjectedFault } from "../injected-fault.ts";

export const limitsFaults: readonly InjectedFault[] = [
  fault(
    "burst",
    "only 30 commands can wait",
    COMMAND_STORE,
    "MAX_WAITING = 64",
    "MAX_WAITING = 30",
  ),
  fault(
    "burst",
    "only 4 commands a second are accepted",
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
    "a stop is rejected while another one waits",
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
    "a stop is rejected while the queue is full",
    COMMAND_STORE,
    "and not is_stop and not replaces",
    "and not replaces",
  ),
  fault(
    "queue",
    "only 50 commands can wait",
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
    "records-retained",
    "only the newest 200 records are retained",
    COMMAND_STORE,
    "if 1 <= seq <= len(self._entries):",
    "if max(1, len(self._entries) - 199) <= seq <= len(self._entries):",
  ),
  fault(
    "events-retained",
    "only 100 events are retained",
    COMMAND_STORE,
    "MAX_EVENTS = 1_000",
    "MAX_EVENTS = 100",
  ),
];
