/**
 * Checks a program in all mazes of a task on the workers of a pool, then diagnoses where it fails.
 * Its progress is a store of its own, because nothing else on the page waits for it.
 */
import {
  countMazes,
  taskVerdict,
  violationOf,
  type Failure,
  type LessonTask,
  type MazeOutcome,
} from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import { isSameBehaviour, type ProgramDocument } from "@corridor/program";
import { createStore, type StoreApi } from "zustand/vanilla";
import { diagnoseAttempts } from "../../simulator/diagnose-attempts.ts";
import type { WorkerPool } from "../../simulator/worker-pool.ts";
import {
  failuresOf,
  resultOf,
  unseenPasses,
  type MazeFailure,
  type MazePass,
} from "../check/attempt-result.ts";
import type { CheckAnswer, CheckRequest } from "../check/checked-task.ts";
import { PoolCheck, type Later } from "../check/pool-check.ts";

export interface CheckProgress {
  state: "idle" | "running" | "done" | "stopped";
  /** number of mazes that are checked, of `count` */
  done: number;
  count: number;
  /** number of mazes in which the program passes */
  passed: number;
  /** null until all mazes before it are checked */
  first: MazeFailure | null;
  /** mazes in which the program fails, in order; empty while the check runs */
  failures: readonly MazeFailure[];
  /** unseen mazes in which the program passes, in order; empty while the check runs */
  passes: readonly MazePass[];
}

export type CheckEnd =
  | { ok: true; answer: CheckAnswer }
  | { ok: false; reason: "stopped" | "failed" };

const idle: CheckProgress = {
  state: "idle",
  done: 0,
  count: 0,
  passed: 0,
  first: null,
  failures: [],
  passes: [],
};

export class ProgramCheck {
  readonly progress: StoreApi<CheckProgress> = createStore<CheckProgress>()(() => idle);
  readonly pool: WorkerPool;
  readonly #check: PoolCheck;
  #request: CheckRequest | null = null;
  #onEnd: ((end: CheckEnd) => void) | null = null;

  constructor(pool: WorkerPool, later: Later) {
    this.pool = pool;
    this.#check = new PoolCheck(pool, later);
  }

  /** Whether the newest check is one of this program in this task. */
  isOf(task: LessonTask, program: ProgramDocument): boolean {
    const request = this.#request;
    if (request === null || !isSameBehaviour(request.program, program)) return false;
    return request.task === task || JSON.stringify(request.task) === JSON.stringify(task);
  }

  /**
   * Starts a check in place of the current one.
   * @param onEnd called once
   */
  start(request: CheckRequest, onEnd: (end: CheckEnd) => void): void {
    this.stop();
    this.progress.setState(idle);
    this.#request = request;
    const { task, program } = request;
    const failure = violationOf(task, program);
    if (failure !== null) {
      onEnd({ ok: true, answer: refused(failure) });
      return;
    }
    this.#onEnd = onEnd;
    const count = countMazes(task);
    const outcomes: (MazeOutcome | undefined)[] = Array.from({ length: count });
    this.progress.setState({ state: "running", count });
    this.#check.start(
      { checks: [{ task, attempts: [program] }] },
      {
        onOutcome: ({ maze }, outcome) => {
          outcomes[maze] = outcome;
        },
        onShow: (done) => {
          const { passed, first } = resultOf(task, program, null, outcomes);
          const ended = this.#check.isRunning ? [] : outcomes;
          const failures = failuresOf(ended);
          const passes = unseenPasses(ended, task.mazes.length);
          this.progress.setState({ done, passed, first, failures, passes });
        },
        onEnd: (reason) => {
          if (reason === "failed") {
            this.progress.setState(idle);
            this.#end({ ok: false, reason });
            return;
          }
          this.progress.setState({ state: "done" });
          this.#diagnose(
            request,
            outcomes.filter((each) => each !== undefined),
          );
        },
      },
    );
  }

  /** Starts the workers that a check of a task needs. */
  prepare(task: LessonTask): void {
    this.pool.open(countMazes(task));
  }

  /** Ends the check. What it has found stays. */
  stop(): void {
    if (this.#check.isRunning) {
      this.#check.stop();
      this.progress.setState({ state: "stopped" });
      this.#end({ ok: false, reason: "stopped" });
    } else if (this.#onEnd !== null) {
      this.pool.stop();
    }
  }

  /** Ends the check, and deletes what it has found. */
  clear(): void {
    this.#check.stop();
    this.#end({ ok: false, reason: "stopped" });
    this.#request = null;
    this.progress.setState(idle);
  }

  /** Diagnoses each failure that a message can name. */
  #diagnose(request: CheckRequest, outcomes: readonly MazeOutcome[]): void {
    const { task, program } = request;
    const verdict = taskVerdict(task, outcomes);
    const mazes = outcomes.slice(0, task.mazes.length);
    const given = failuresOf(mazes).flatMap(({ maze }) => (maze === null ? [] : [maze]));
    const { failedUnseen } = verdict;
    const unseen = failedUnseen === null ? [] : [task.mazes.length + failedUnseen - 1];
    const failed = [...given, ...unseen];
    const found: (Diagnosis | null)[] = failed.map(() => null);
    const end = (): void => {
      if (this.#request !== request) return;
      const diagnoses = mazes.map((_, maze) => found[given.indexOf(maze)] ?? null);
      const unseenDiagnosis = failedUnseen === null ? null : (found.at(-1) ?? null);
      const answer = { verdict: { ...verdict, mazes }, diagnoses, unseenDiagnosis };
      this.#end({ ok: true, answer });
    };
    const attempts = failed.map((maze) => ({ task, program, maze, reader: "student" as const }));
    diagnoseAttempts(this.pool, attempts, {
      onDiagnosis: (diagnosis, at) => {
        found[at] = diagnosis;
      },
      // Also if another job ended it: the verdict counts without its explanation.
      onEnd: end,
    });
  }

  #end(end: CheckEnd): void {
    const onEnd = this.#onEnd;
    this.#onEnd = null;
    onEnd?.(end);
  }
}

function refused(failure: Failure): CheckAnswer {
  const verdict = { passed: false, failure, failedUnseen: null, unseenFailures: [], mazes: [] };
  return { verdict, diagnoses: [], unseenDiagnosis: null };
}
