/** Faults in the rejection of invalid requests. */
import {
  COMMAND_REQUESTS,
  COMMAND_STORE,
  SERVER,
  VALIDATION,
  fault,
  type InjectedFault,
} from "../injected-fault.ts";

export const invalidInputFaults: readonly InjectedFault[] = [
  fault(
    "bad-command",
    "a rejection does not name the field",
    COMMAND_REQUESTS,
    '{"path": path, "found"',
    '{"path": "", "found"',
  ),
  fault(
    "bad-command",
    "wheel powers up to 9 are accepted",
    COMMAND_REQUESTS,
    '"left": (-1, 1, "a wheel power")',
    '"left": (-9, 9, "a wheel power")',
  ),
  fault(
    "bad-command",
    "unknown fields are ignored",
    COMMAND_REQUESTS,
    "if name not in allowed and name not in",
    "if False and name not in",
  ),
  fault(
    "body-size",
    "a body of 64 KiB is accepted",
    SERVER,
    "MAX_BYTES = 16 * 1024",
    "MAX_BYTES = 64 * 1024",
  ),
  fault(
    "body-type",
    "any Content-Type is accepted as JSON",
    SERVER,
    'if kind != "application/json":',
    "if False:",
  ),
  fault(
    "bad-query",
    "a wait of 99 s is accepted",
    VALIDATION,
    "MAX_WAIT = 25.0",
    "MAX_WAIT = 99.0",
  ),
  fault(
    "no-command",
    "an unknown command is 400",
    COMMAND_STORE,
    'Problem(404, "no-command"',
    'Problem(400, "no-command"',
  ),
  fault(
    "no-path",
    "an unknown method is 404",
    SERVER,
    'raise method_not_allowed(self.command, ", ".join(calls))',
    "raise not_found()",
  ),
  fault(
    "bad-survived",
    "a rejected command moves the robot",
    SERVER,
    "        request = parse_command(read_json(body))\n",
    [
      "        try:",
      "            request = parse_command(read_json(body))",
      "        except Problem:",
      "            with self.server.store.changed:",
      '                self.server.store.submit(CommandRequest({"action": "turn", "degrees": 50}), None)',
      "            raise\n",
    ].join("\n"),
  ),
];
