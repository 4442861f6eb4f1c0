/** Faults in leases and the dead man's switch. */
import { COMMAND_STORE, CONTROLLER, SERVER, fault, type InjectedFault } from "../injected-fault.ts";

export const leasesFaults: readonly InjectedFault[] = [
  fault(
    "silence",
    "forward never ends without requests",
    CONTROLLER,
    "SCRIPT_TIMEOUT = 3.0",
    "SCRIPT_TIMEOUT = 1e9",
  ),
  fault(
    "silence",
    "an open event stream renews forward",
    SERVER,
    "                store.changed.wait_for(\n                    lambda: store.newest_event > n",
    "                store.last_contact = time.monotonic()\n                store.changed.wait_for(\n                    lambda: store.newest_event > n",
  ),
  fault(
    "silence-reverse",
    "reverse never ends without requests",
    CONTROLLER,
    "is_connected = not is_drive and",
    'is_connected = command["action"] == "reverse" or not is_drive and',
  ),
  {
    fault: "reading does not renew forward",
    caughtBy: "renewed-by-reading",
    edits: [
      {
        file: SERVER,
        before: "        self.server.store.last_contact = time.monotonic()\n",
        after: "",
      },
      {
        file: SERVER,
        before:
          "                store.open_requests -= 1\n                store.last_contact = time.monotonic()\n",
        after: "                store.open_requests -= 1\n",
      },
    ],
  },
  fault(
    "renewed-by-waiting",
    "a waiting request does not renew reverse",
    CONTROLLER,
    "is_connected = not is_drive and self._store.open_requests > 0",
    "is_connected = False",
  ),
  fault(
    "drive-lease",
    "a drive lease of 5 s",
    CONTROLLER,
    "DRIVE_LEASE = 0.5",
    "DRIVE_LEASE = 5.0",
  ),
  fault(
    "drive-lease-asked",
    "the lease in a drive command is ignored",
    CONTROLLER,
    "(entry.request.lease or DRIVE_LEASE * 1_000)",
    "(DRIVE_LEASE * 1_000)",
  ),
  fault(
    "drive-not-renewed",
    "reading renews a drive",
    CONTROLLER,
    "since = self._started_at if is_drive else max(",
    "since = max(",
  ),
  fault(
    "drive-renewed",
    "a drive waits until the previous drive has ended",
    CONTROLLER,
    "        if self._store.has_waiting:\n",
    "        if self._store.has_waiting and not entry.request.lease:\n",
  ),
  {
    fault: "waiting drives run one after the other",
    caughtBy: "drive-newest",
    edits: [
      {
        file: CONTROLLER,
        before: "        if self._store.has_waiting:\n",
        after:
          '        if self._store.has_waiting and (entry.request.lease or command["action"] != "drive"):\n',
      },
      {
        file: COMMAND_STORE,
        before: "while len(self._waiting) > 1 and all(",
        after: "while False and all(",
      },
    ],
  },
  fault(
    "runs-to-end",
    "a drive with milliseconds ends without requests",
    CONTROLLER,
    "        if not _has_no_end(command):\n            return False\n",
    [
      "        if not _has_no_end(command):",
      "            last_contact = max(self._started_at, self._store.last_contact)",
      "            if self._store.open_requests > 0 or now - last_contact < SCRIPT_TIMEOUT:",
      "                return False",
      '            self._end(entry, "cancelled", "its script is silent")',
      "            return True\n",
    ].join("\n"),
  ),
  fault(
    "gives-way",
    "forward does not end for the next command",
    CONTROLLER,
    "        if self._store.has_waiting:\n",
    '        if self._store.has_waiting and command["action"] == "drive":\n',
  ),
  fault(
    "drive-burst",
    "each drive of a burst runs",
    COMMAND_STORE,
    "while len(self._waiting) > 1 and all(",
    "while False and all(",
  ),
];
