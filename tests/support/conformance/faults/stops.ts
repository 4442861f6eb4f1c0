/** Faults in stops and other ways to cancel commands. */
import { COMMAND_STORE, CONTROLLER, SERVER, fault, type InjectedFault } from "../injected-fault.ts";

export const stopsFaults: readonly InjectedFault[] = [
  fault(
    "stop-overtakes",
    "a stop does not cancel waiting turns",
    COMMAND_STORE,
    "for entry in [self.running, *self._waiting]:\n            if entry is not None:",
    "for entry in [self.running]:\n            if entry is not None:",
  ),
  fault(
    "stop-overtakes",
    "a stop ends no command",
    COMMAND_STORE,
    "        if is_stop:\n",
    "        if False:\n",
  ),
  fault(
    "stop-delete",
    "DELETE does not stop the robot",
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
    "cancel-waiting",
    "a waiting command cannot be cancelled",
    COMMAND_STORE,
    'if not entry.ended:\n            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)',
    'if entry is self.running:\n            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)',
  ),
  fault(
    "cancel-running",
    "a running command cannot be cancelled",
    COMMAND_STORE,
    'if not entry.ended:\n            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)',
    'if entry in self._waiting:\n            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)',
  ),
  fault(
    "replace",
    "replace waits like any other command",
    COMMAND_STORE,
    "        elif replaces:\n",
    "        elif is_reset:\n",
  ),
  fault(
    "first-ending",
    "a DELETE overwrites a final state",
    COMMAND_STORE,
    'if not entry.ended:\n            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)',
    'if True:\n            self.end(entry, "cancelled", CANCELLED_BY_SCRIPT)',
  ),
];
