/** What happened in the ticks since the last news and is worth telling: the newest bump, and the goal. */
import type { Run } from "@corridor/recording";
import type { DriverName, LineRef } from "@corridor/protocol";
import type { DiagnosedRun } from "./diagnose-run.ts";
import type { RunEvent } from "./worker-messages.ts";

export class Moments {
  #waiting: RunEvent[] = [];

  /** Notes what just happened; `line` and `driver` were in charge, a bump may be `explained`. */
  add(
    kind: RunEvent["kind"],
    run: Run,
    line: LineRef | null,
    driver: DriverName,
    explained: DiagnosedRun | null = null,
  ): void {
    const { tick, pose, bumps } = run;
    const cause = kind === "bump" ? run.cause : null;
    // Many bumps in one frame are one to a watcher; the goal is told in any case.
    this.#waiting = this.#waiting.filter((each) => each.kind !== kind);
    const diagnosis = explained?.diagnosis ?? null;
    const program = kind === "goal" ? run.program : (explained?.program ?? null);
    this.#waiting.push({ kind, tick, pose, line, driver, bumps, cause, diagnosis, program });
  }

  /** What came after the end of `tick` has not happened. */
  forgetAfter(tick: number): void {
    this.#waiting = this.#waiting.filter((each) => each.tick <= tick);
  }

  take(): RunEvent[] {
    const taken = this.#waiting;
    this.#waiting = [];
    return taken;
  }
}
