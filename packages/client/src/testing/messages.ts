/** Messages as the relay sends them, for tests. */
import type { Command, CommandRecord, Snapshot } from "@corridor/protocol";

export const ADDRESS = "http://localhost:8080/r/AAAAAAAAAAAAAAAAAAAAAA#drv_BBBBBBBBBBBBBBBBBBBBBB";

/** A snapshot of a robot that stands in a corridor. */
export function snapshot(change: Partial<Snapshot> = {}): Snapshot {
  return {
    seq: 1,
    tick: 60,
    state: "running",
    driver: "remote",
    sensors: { front: 250.5, right: 50, back: 49.5, left: 50 },
    pose: { x: 150, y: 150, heading: 90 },
    motion: "stop",
    bumps: 0,
    bumping: false,
    goalReached: false,
    line: null,
    command: null,
    ...change,
  };
}

/** The record of a command. */
export function record(
  seq: number,
  key: string,
  command: Command,
  change: Partial<CommandRecord> = {},
): CommandRecord {
  return {
    seq,
    key,
    action: command.action,
    command,
    state: "accepted",
    reason: null,
    acceptedAt: "2026-01-01T00:00:00.000Z",
    pose: null,
    distance: null,
    duplicate: false,
    ...change,
  };
}
