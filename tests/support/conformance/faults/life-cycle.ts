/** Faults in the states of a command. */
import {
  COMMAND_REQUESTS,
  COMMAND_STORE,
  SERVER,
  fault,
  type InjectedFault,
} from "../injected-fault.ts";

export const lifeCycleFaults: readonly InjectedFault[] = [
  fault("accepted", "the response has no Location", SERVER, '{"Location": location}', "{}"),
  fault(
    "numbers",
    "every other number is skipped",
    COMMAND_STORE,
    "        self._entries.append(entry)\n",
    "        self._entries += [entry, entry]\n",
  ),
  fault(
    "actions",
    "short drives are rejected",
    COMMAND_REQUESTS,
    '"milliseconds": (1, 60_000',
    '"milliseconds": (100, 60_000',
  ),
  fault(
    "record-command",
    "a record lacks the milliseconds",
    COMMAND_STORE,
    '"command": self.request.command,',
    '"command": {k: v for k, v in self.request.command.items() if k != "milliseconds"},',
  ),
  fault(
    "order",
    "the newest command starts first",
    COMMAND_STORE,
    "self._waiting.popleft()",
    "self._waiting.pop()",
  ),
  fault(
    "record-wait",
    "a record waits until the command has ended, whatever `wait` is",
    SERVER,
    "self._wait(query, lambda: entry.ended)",
    'self._wait({"wait": "25"} if "." in query.get("wait", "") else query, lambda: entry.ended)',
  ),
];
