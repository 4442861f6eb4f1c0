/**
 * Observes the displayed run for its diagnosis: detects a robot that gets nowhere, and requests why
 * a run failed. Each line's bump is explained once per run, so that the user can continue.
 */
import { LoopDetector, type LoopNotice } from "@corridor/coach";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { DriverName, LineRef } from "@corridor/protocol";
import type { Recording, Run } from "@corridor/recording";
import type { DiagnosedRun, diagnoseAt, diagnoseBump, TaskOf } from "./diagnose-run.ts";

/** The diagnostics module, which is loaded on demand. */
export interface Diagnostics {
  diagnoseBump: typeof diagnoseBump;
  diagnoseAt: typeof diagnoseAt;
}

export class RunDiagnosis {
  readonly #explained = new Set<LineRef>();
  #diagnostics: Diagnostics | null = null;
  #detector: LoopDetector | null = null;
  #maze: MazeDocument | null = null;
  #program: ProgramDocument | null = null;

  /** The module has loaded. */
  use(diagnostics: Diagnostics): void {
    this.#diagnostics = diagnostics;
  }

  /** A new run: explanations of the previous one may be repeated. */
  begin(): void {
    this.#explained.clear();
    this.#detector = null;
  }

  /**
   * Observes a tick that `line` drove.
   * @param isWaiting whether the line's action is `stop`
   * @returns the sign that the robot gets nowhere; usually null
   */
  observe(run: Run, line: LineRef, isWaiting: boolean): LoopNotice | null {
    this.#follow(run);
    this.#detector ??= new LoopDetector(run.maze);
    return this.#detector.update(run.cell, run.isStopped, run.isManoeuvring, line, isWaiting);
  }

  /**
   * The newest tick ended in a bump.
   * @returns null for a bump by hand or an explained one; "later" if the module has not loaded yet
   */
  bump(
    recording: Recording,
    driver: DriverName,
    line: LineRef | null,
    task: TaskOf | null,
  ): DiagnosedRun | "later" | null {
    const isProgram = driver === "program" && line !== null;
    if (!isProgram && driver !== "remote") return null;
    if (isProgram) {
      this.#follow(recording.run);
      if (this.#explained.has(line)) return null;
    }
    if (isProgram) this.#explained.add(line);
    return this.explain(recording, isProgram ? line : null, task);
  }

  /** Explains why the newest tick ended in a bump, even if it was explained before. */
  explain(
    recording: Recording,
    line: LineRef | null,
    task: TaskOf | null,
  ): DiagnosedRun | "later" | null {
    if (this.#diagnostics === null) return "later";
    return this.#diagnostics.diagnoseBump(recording, line, task);
  }

  /** The program's robot gets nowhere, or the time is over, at this tick. */
  noGoal(
    recording: Recording,
    failure: "late" | LoopNotice,
    tick: number,
    task: TaskOf | null,
  ): DiagnosedRun | "later" | null {
    if (this.#diagnostics === null) return "later";
    return this.#diagnostics.diagnoseAt(recording, failure, tick, task);
  }

  #follow({ maze, program }: Run): void {
    if (maze === this.#maze && program === this.#program) return;
    this.#maze = maze;
    this.#program = program;
    this.begin();
  }
}
