/**
 * Checks hand-ins on the workers of a pool. Identical programs run once. After the check, each
 * failed run is recorded, so that it can be watched.
 */
import {
  checkedRow,
  isProgram,
  mazeOf,
  violationOf,
  violationRow,
  type Attempt,
  type Failure,
  type Graded,
  type LessonRow,
  type LessonTask,
  type MazeOutcome,
} from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import type { HandIn } from "@corridor/link";
import { createStore, type StoreApi } from "zustand/vanilla";
import { resultOf, type AttemptResult } from "../../model/check/attempt-result.ts";
import { PoolCheck, SHOW_MS, type Later } from "../../model/check/pool-check.ts";
import { diagnoseAttempts } from "../../simulator/diagnose-attempts.ts";
import type { AttemptToDiagnose, RunToRecord } from "../../simulator/protocol/pool-messages.ts";
import { recordRuns } from "../../simulator/record-runs.ts";
import type { WorkerPool } from "../../simulator/worker-pool.ts";
import {
  attemptText,
  type ChosenTask,
  type HandInEntry,
  type HandInProblem,
} from "./hand-in-entries.ts";
import { failureAddress } from "./failure-address.ts";

/** A row of the table: a hand-in and a task, or a hand-in that cannot be read. */
export interface HandInRow {
  /** number of the hand-in, from 1 */
  number: number;
  source: HandInEntry["source"];
  /** name of the program; empty without one */
  title: string;
  /** number of another hand-in with the identical program; null if there is none */
  sameAs: number | null;
  checked:
    | ({ ok: true; task: ChosenTask } & Pick<Subject, "result" | "row" | "watch" | "diagnosis">)
    | ({ ok: false } & HandInProblem);
}

export interface CheckState {
  state: "idle" | "running" | "done" | "stopped" | "failed";
  /** finished runs, of `count` */
  done: number;
  count: number;
  rows: readonly HandInRow[];
}

/** An attempt at a task. Several rows can share it. */
interface Subject {
  task: ChosenTask;
  attempt: Attempt;
  violation: Failure | null;
  outcomes: (MazeOutcome | undefined)[];
  result: AttemptResult;
  /** as in the output of `grade`, but without a name; null until all mazes are checked */
  row: LessonRow | null;
  /** address at which the first failed run can be watched; null if there is none yet */
  watch: string | null;
  /** why the first failed run failed; null until it is known */
  diagnosis: Diagnosis | null;
}

const idle: CheckState = { state: "idle", done: 0, count: 0, rows: [] };

export class HandInCheck {
  readonly store: StoreApi<CheckState> = createStore<CheckState>()(() => idle);
  readonly #pool: WorkerPool;
  readonly #check: PoolCheck;
  readonly #later: Later;
  readonly #nameMaze: (task: LessonTask, maze: number) => string;
  #subjects: Subject[] = [];
  /** subjects with new outcomes that are not displayed yet */
  #changed = new Set<Subject>();
  #rowsOf: () => HandInRow[] = () => [];

  /**
   * @param nameMaze names the maze of a run that is watched, in the language of the page
   */
  constructor(
    pool: WorkerPool,
    later: Later,
    nameMaze: (task: LessonTask, maze: number) => string,
  ) {
    this.#pool = pool;
    this.#check = new PoolCheck(pool, later);
    this.#later = later;
    this.#nameMaze = nameMaze;
  }

  start(tasks: readonly ChosenTask[], entries: readonly HandInEntry[]): void {
    const { subjects, rowsOf } = prepare(tasks, entries);
    this.#subjects = subjects;
    this.#rowsOf = rowsOf;
    this.#changed = new Set();
    const groups = tasks.map((task) =>
      subjects.filter((each) => each.task === task && each.violation === null),
    );
    const checks = tasks.map(({ task }, at) => ({
      task,
      attempts: (groups[at] ?? []).map(({ attempt }) => attempt),
    }));
    this.store.setState({ ...idle, state: "running", rows: rowsOf() });
    const count = this.#check.start(
      { checks },
      {
        onOutcome: ({ check, attempt, maze }, outcome) => {
          const subject = groups[check]?.[attempt];
          if (subject === undefined) return;
          subject.outcomes[maze] = outcome;
          this.#changed.add(subject);
        },
        onShow: (done) => {
          this.store.setState({ done });
          this.#show();
        },
        onEnd: (state) => {
          this.store.setState({ state });
          if (state === "done") void this.#explain();
        },
      },
    );
    this.store.setState({ count });
  }

  /** Ends the check; the results so far stay. */
  stop(): void {
    if (!this.#check.isRunning) return;
    this.#check.stop();
    this.store.setState({ state: "stopped" });
    void this.#explain();
  }

  /** Ends the check, and deletes its results. */
  clear(): void {
    this.#check.stop();
    this.#pool.stop();
    this.#subjects = [];
    this.#changed.clear();
    this.store.setState(idle);
  }

  #show(): void {
    for (const subject of this.#changed) decide(subject);
    this.#changed.clear();
    this.store.setState({ rows: this.#rowsOf() });
  }

  /** Records the first failed run of each attempt, so that it can be watched, and diagnoses it. */
  async #explain(): Promise<void> {
    const subjects = this.#subjects;
    const failed = subjects.flatMap((subject) => {
      const { first } = subject.result;
      if (first === null || first.maze === null) return [];
      const { task } = subject.task;
      const run: RunToRecord = {
        maze: { ...mazeOf(task, first.maze), name: this.#nameMaze(task, first.maze) },
        attempt: subject.attempt,
        ticks: first.failure.tick ?? 0,
      };
      return [{ subject, run, maze: first.maze }];
    });
    await recordRuns(
      this.#pool,
      failed.map(({ run }) => run),
      (written, at) => {
        const each = failed[at];
        if (each === undefined || this.#subjects !== subjects) return;
        each.subject.watch = failureAddress(each.run, written);
        this.#showLater(each.subject);
      },
    );
    if (this.#subjects !== subjects || this.#check.isRunning) return;
    const programs = failed.flatMap(({ subject, maze }) => {
      const { attempt, task } = subject;
      if (!isProgram(attempt)) return [];
      const toDiagnose: AttemptToDiagnose = {
        task: task.task,
        program: attempt,
        maze,
        reader: "teacher",
      };
      return [{ subject, toDiagnose }];
    });
    diagnoseAttempts(
      this.#pool,
      programs.map(({ toDiagnose }) => toDiagnose),
      {
        onDiagnosis: (diagnosis, at) => {
          const subject = programs[at]?.subject;
          if (subject === undefined || this.#subjects !== subjects) return;
          subject.diagnosis = diagnosis;
          this.#showLater(subject);
        },
        onEnd: () => undefined,
      },
    );
  }

  /** Displays what was found after the check, together with what follows soon. */
  #showLater(subject: Subject): void {
    this.#changed.add(subject);
    if (this.#changed.size > 1) return;
    this.#later(() => {
      if (this.#changed.size > 0) this.#show();
    }, SHOW_MS);
  }
}

/** Groups the hand-ins by their program. */
function prepare(
  tasks: readonly ChosenTask[],
  entries: readonly HandInEntry[],
): { subjects: Subject[]; rowsOf: () => HandInRow[] } {
  const numbers = new Map<string, number[]>();
  const texts = entries.map(({ read }, at) => {
    const text = read.ok ? attemptText(read.value.attempt) : null;
    if (text !== null) numbers.set(text, [...(numbers.get(text) ?? []), at + 1]);
    return text;
  });
  const subjects = new Map<string, Subject>();
  const rows = entries.flatMap(({ source, read }, at): (() => HandInRow)[] => {
    const number = at + 1;
    const text = texts[at] ?? "";
    const sameAs = numbers.get(text)?.find((each) => each !== number) ?? null;
    if (!read.ok) return [() => problemRow(number, source, read)];
    const { attempt } = read.value;
    const title = "name" in attempt ? attempt.name : "";
    const own = tasks.filter((task) => isFor(task, read.value));
    if (own.length === 0) {
      const problem = `Not checked: this code belongs to task ${(read.value.task ?? 0) + 1}`;
      return [() => problemRow(number, source, { code: "other-task", problems: [], problem })];
    }
    return own.map((task) => {
      const key = `${task.number} ${text}`;
      const subject = subjects.get(key) ?? subjectOf(task, attempt);
      subjects.set(key, subject);
      return () => ({
        number,
        source,
        title,
        sameAs,
        checked: {
          ok: true,
          task,
          result: subject.result,
          row: subject.row,
          watch: subject.watch,
          diagnosis: subject.diagnosis,
        },
      });
    });
  });
  return { subjects: [...subjects.values()], rowsOf: () => rows.map((row) => row()) };
}

/** Whether a hand-in is checked in a task: a completion code belongs to one. */
function isFor({ number }: ChosenTask, { task }: HandIn): boolean {
  return task === null || task + 1 === number;
}

function problemRow(
  number: number,
  source: HandInEntry["source"],
  { code, problems, problem }: HandInProblem,
): HandInRow {
  return {
    number,
    source,
    title: "",
    sameAs: null,
    checked: { ok: false, code, problems, problem },
  };
}

function subjectOf(task: ChosenTask, attempt: Attempt): Subject {
  const violation = violationOf(task.task, attempt);
  const result = resultOf(task.task, attempt, violation, []);
  const subject: Subject = {
    task,
    attempt,
    violation,
    outcomes: [],
    result,
    row: null,
    watch: null,
    diagnosis: null,
  };
  decide(subject);
  return subject;
}

/** Updates the result from the outcomes so far. */
function decide(subject: Subject): void {
  const { task, attempt, violation, outcomes } = subject;
  subject.result = resultOf(task.task, attempt, violation, outcomes);
  const graded: Graded = { name: "", attempt, ...task };
  if (violation !== null) {
    subject.row = violationRow(graded, violation).row;
  } else if (subject.result.verdict !== "open") {
    const known = outcomes.filter((each) => each !== undefined);
    subject.row = checkedRow(graded, known).row;
  }
}
