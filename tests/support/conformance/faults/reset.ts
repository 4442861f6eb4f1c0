/** Faults in resets. */
import { COMMAND_STORE, CONTROLLER, fault, HOST, type InjectedFault } from "../injected-fault.ts";

export const resetFaults: readonly InjectedFault[] = [
  fault(
    "reset",
    "a reset leaves the robot where it is",
    CONTROLLER,
    "        self._body.reset()\n",
    "",
  ),
  fault(
    "reset",
    "a reset continues the run",
    CONTROLLER,
    "        self._up_since, self._goal_reached = now, False\n",
    "        self._goal_reached = False\n",
  ),
  fault(
    "reset-replaces",
    "a reset waits for earlier commands",
    COMMAND_STORE,
    "        replaces = request.replace or is_reset\n",
    "        replaces = request.replace\n",
  ),
  fault(
    "reset-rate",
    "any number of resets is accepted",
    COMMAND_STORE,
    "        if now < self._next_reset:\n",
    "        if now < 0:\n",
  ),
  {
    fault: "a host without reset rejects it as an unknown action",
    caughtBy: "reset-not-supported",
    edits: [
      {
        file: HOST,
        before: "    options = parser.parse_args()\n",
        after: "    options = parser.parse_args()\n    options.reset = False\n",
      },
      {
        file: COMMAND_STORE,
        before: 'raise Problem(422, "not-supported", detail)',
        after: 'raise Problem(400, "bad-request", detail)',
      },
    ],
  },
];
