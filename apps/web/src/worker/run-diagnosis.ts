/**
 * Follows the run on the screen for its diagnosis: notices a robot that gets nowhere, and asks why a run
 * failed. Each line's bump is explained once in a run, or nobody could run on.
 */
import { LoopWatch, type LoopNotice } from "@corridor/coach";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { DriverName, LineRef } from "@corridor/protocol";
import type { Recording, Run } from "@corridor/recording";
import type { DiagnosedRun, diagnoseAt, diagnoseBump, TaskOf } from "./diagnose-run.ts";

/** The module that diagnoses; it comes in a file of its own. */
export interface Diagnostics {
  diagnoseBump: typeof diagnoseBump;
  diagnoseAt: typeof diagnoseAt;
}

export class RunDiagnosis {
  readonly #explained = new Set<LineRef>();
  #diagnostics: Diagnostics | null = null;
  #watch: LoopWatch | null = null;
  #maze: MazeDocument | null = null;
  #program: ProgramDocument | null = null;

  /** The module has come. */
  use(diagnostics: Diagnostics): void {
    this.#diagnostics = diagnostics;
  }

  /** A new run: what was said of the one before may be said again. */
  begin(): void {
    this.#explained.clear();
    this.#watch = null;
  }

  /**
   * Looks at a tick that `line` drove.
   * @param isWaiting whether the line says `stop`
   * @returns the sign that the robot gets nowhere; mostly null
   */
  look(run: Run, line: LineRef, isWaiting: boolean): LoopNotice | null {
    this.#follow(run);
    this.#watch ??= new LoopWatch(run.maze);
    return this.#watch.look(run.cell, run.isStopped, run.isManoeuvring, line, isWaiting);
  }

  /**
   * The newest tick ended in a bump.
   * @returns null for a hand's, and for one explained before; "later" where the module has not come yet
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

  /** Why the newest tick ended in a bump, whether it was explained before or not. */
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
