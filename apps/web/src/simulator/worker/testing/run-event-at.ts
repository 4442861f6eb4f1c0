/** A run event in tests: line 1 drove, and the cause is unknown. */
import type { RunEvent } from "../../protocol/worker-messages.ts";

export function runEventAt(
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
