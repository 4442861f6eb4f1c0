/** A moment in tests as the worker tells it: line 1 drove, and nothing is known of why. */
import type { RunEvent } from "../worker-messages.ts";

export function momentAt(
  kind: RunEvent["kind"],
  tick: number,
  program: RunEvent["program"] = null,
): RunEvent {
  const pose = { x: 150, y: 150, heading: 0 };
  return {
    kind,
    tick,
    pose,
    line: 0,
    driver: "program",
    bumps: 1,
    cause: null,
    diagnosis: kind === "bump" ? { event: { kind: "late", tick }, cause: null, fixes: [] } : null,
    program,
  };
}
