/** Events of the ticks since the last update: the newest bump, and the goal. */
import type { Run } from "@corridor/recording";
import type { DriverName, LineRef } from "@corridor/protocol";
import type { DiagnosedRun } from "./diagnose-run.ts";
import type { RunEvent } from "../protocol/worker-messages.ts";

export class RunEvents {
  #pending: RunEvent[] = [];

  /** Adds an event; `line` and `driver` were in charge, a bump may be `explained`. */
  add(
    kind: RunEvent["kind"],
    run: Run,
    line: LineRef | null,
    driver: DriverName,
    explained: DiagnosedRun | null = null,
  ): void {
    const { tick, pose, bumps } = run;
    const cause = kind === "bump" ? run.cause : null;
    // Several bumps in one frame look like one; the goal is always reported.
    this.#pending = this.#pending.filter((each) => each.kind !== kind);
    const diagnosis = explained?.diagnosis ?? null;
    const program = kind === "goal" ? run.program : (explained?.program ?? null);
    this.#pending.push({ kind, tick, pose, line, driver, bumps, cause, diagnosis, program });
  }

  /** Discards events after `tick`. */
  truncate(tick: number): void {
    this.#pending = this.#pending.filter((each) => each.tick <= tick);
  }

  take(): RunEvent[] {
    const taken = this.#pending;
    this.#pending = [];
    return taken;
  }
}
