/** Faults in the key of the address. */
import { HOST, SERVER, fault, type InjectedFault } from "../injected-fault.ts";

export const accessFaults: readonly InjectedFault[] = [
  fault("key-address", "the log cannot be read", SERVER, '"GET": lambda: self._log(query),', ""),
  fault(
    "key-required",
    "401 does not ask for a bearer key",
    SERVER,
    'raise Problem(401, "not-authorised", detail, headers={"WWW-Authenticate": "Bearer"})',
    'raise Problem(401, "not-authorised", detail)',
  ),
  fault(
    "key-wrong",
    "a wrong key of the same form drives",
    SERVER,
    "not hmac.compare_digest(key.encode(), self.server.key.encode())",
    "not key.startswith(self.server.key[:8])",
  ),
  fault(
    "key-wrong-reading",
    "any key can read",
    SERVER,
    "if key is None or not hmac",
    'if key is None or self.command != "GET" and not hmac',
  ),
  fault(
    "key-secret",
    "a rejection contains the key that was sent",
    SERVER,
    'raise Problem(401, "not-authorised", detail, headers=',
    'raise Problem(401, "not-authorised", f"{detail} Not {key}.", headers=',
  ),
  fault(
    "features",
    "the host lists the stop as not offered",
    HOST,
    '"maze": "It has no map of the room.",',
    '"maze": "It has no map of the room.", "stop": "It has no brakes.",',
  ),
];
