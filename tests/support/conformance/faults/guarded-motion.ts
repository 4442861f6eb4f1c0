/** Faults in guarded motions. */
import {
  COMMAND_REQUESTS,
  COMMAND_STORE,
  CONDITIONS,
  CONTROLLER,
  fault,
  type InjectedFault,
} from "../injected-fault.ts";

export const guardedMotionFaults: readonly InjectedFault[] = [
  fault(
    "until",
    "<= is true 100 cm too late",
    CONDITIONS,
    '"<=": lambda reading, limit: reading <= limit',
    '"<=": lambda reading, limit: reading <= limit - 100',
  ),
  fault(
    "until-start",
    "conditions are not evaluated before the first step",
    CONTROLLER,
    "            if self._is_reached(command):\n                return",
    "            if self._distance > 0 and self._is_reached(command):\n                return",
  ),
  fault(
    "until-goal",
    "the goal is no condition",
    CONDITIONS,
    "        return at_goal\n",
    "        return False\n",
  ),
  fault(
    "until-collided",
    "a wall ends a guarded motion as completed",
    CONTROLLER,
    '            if self._body.bumping:\n                self._end(entry, "collided")',
    '            if self._body.bumping:\n                self._end(entry, "completed" if "until" in command else "collided")',
  ),
  fault(
    "until-waits",
    "a guarded motion gives way to the next command",
    CONTROLLER,
    '        if "until" in command:\n',
    '        if "until" in command and not self._store.has_waiting:\n',
  ),
  fault(
    "until-drive",
    "of waiting guarded drives only the newest runs",
    COMMAND_STORE,
    'has_end = "milliseconds" in command or "until" in command',
    'has_end = "milliseconds" in command',
  ),
  fault(
    "until-silence",
    "a guarded motion never ends without requests",
    CONTROLLER,
    "if self._store.open_requests > 0 or now - last_contact < SCRIPT_TIMEOUT:",
    "if now >= last_contact:",
  ),
  fault(
    "until-ended-early",
    "a stop does not end a guarded motion",
    COMMAND_STORE,
    "            if entry is not None:\n                self.end(entry, state, reason)",
    '            if entry is not None and "until" not in entry.request.command:\n                self.end(entry, state, reason)',
  ),
  fault(
    "until-key",
    "until is not compared",
    COMMAND_STORE,
    "if before.request.command == request.command:",
    'if {**before.request.command, "until": 0} == {**request.command, "until": 0}:',
  ),
  fault(
    "until-invalid",
    "until is accepted with every action",
    COMMAND_REQUESTS,
    'if fields["action"] not in GUARDED_ACTIONS or has_end:',
    "if has_end:",
  ),
];
