/** Faults in snapshots, the maze and the command log. */
import {
  COMMAND_STORE,
  CONTROLLER,
  HOST,
  SERVER,
  fault,
  type InjectedFault,
} from "../injected-fault.ts";

export const readingFaults: readonly InjectedFault[] = [
  fault(
    "snapshot",
    "a snapshot has the state paused",
    CONTROLLER,
    '"state": "running"',
    '"state": "paused"',
  ),
  fault(
    "snapshot-command",
    "a snapshot contains the newest command while the robot stands",
    CONTROLLER,
    '"command": None if running is None else running.seq',
    '"command": len(self._store._entries) or None',
  ),
  fault(
    "reading-wait",
    "a reading waits for 12 s, whatever `wait` is",
    SERVER,
    'self._wait(query, lambda: self.server.controller.snapshot["seq"] > after)',
    'self._wait({"wait": "12"}, lambda: self.server.controller.snapshot["seq"] > after)',
  ),
  fault(
    "maze",
    "the host has no maze and lists it as offered",
    HOST,
    '"maze": "It has no map of the room.",',
    "",
  ),
  fault(
    "log",
    "the log lacks a record",
    COMMAND_STORE,
    "self._entries[after : after + LOG_PAGE]",
    "self._entries[after + 1 : after + LOG_PAGE]",
  ),
];
