/** Messages and time for tests. */
/** Addresses that every client, in every language, accepts or rejects. */
export { default as robotAddresses } from "./robot-addresses.json" with { type: "json" };
export { ManualTimers, settled } from "./manual-timers.ts";
import type { Snapshot } from "../snapshot.ts";

/** A snapshot of a robot that stands in a corridor under remote control. */
export function snapshotOf(change: Partial<Snapshot> = {}): Snapshot {
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
