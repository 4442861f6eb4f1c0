/**
 * Checks hand-ins on the workers of a pool. Identical programs run once. After the check, each
 * failed run is recorded, so that it can be watched.
 */
import {
  checkedRow,
  checkUnitAt,
  countCheckUnits,
  mazeOf,
  violationOf,
  violationRow,
  type Attempt,
  type CheckJob,
  type Failure,
  type Graded,
  type LessonRow,
  type LessonTask,
  type MazeOutcome,
} from "@corridor/challenge";
import type { HandIn } from "@corridor/link";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { RunToRecord } from "../../simulator/protocol/pool-messages.ts";
import { recordRuns } from "../../simulator/record-runs.ts";
import type { WorkerPool } from "../../simulator/worker-pool.ts";
import {
  attemptText,
  type ChosenTask,
  type HandInEntry,
  type HandInProblem,
} from "./hand-in-entries.ts";
import { resultOf, type HandInResult } from "./hand-in-result.ts";
import { watchAddress } from "./watch-address.ts";

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
    | ({ ok: true; task: ChosenTask } & Pick<Subject, "result" | "row" | "watch">)
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
  result: HandInResult;
  /** as in the output of `grade`, but without a name; null until all mazes are checked */
  row: LessonRow | null;
  /** address at which the first failed run can be watched; null if there is none yet */
  watch: string | null;
}

const idle: CheckState = { state: "idle", done: 0, count: 0, rows: [] };

export class HandInCheck {
  readonly store: StoreApi<CheckState> = createStore<CheckState>()(() => idle);
  readonly #pool: WorkerPool;
  readonly #later: (show: () => void) => void;
  readonly #nameMaze: (task: LessonTask, maze: number) => string;
  #subjects: Subject[] = [];
  /** subjects with new outcomes that are not displayed yet */
  #changed = new Set<Subject>();
  #rowsOf: () => HandInRow[] = () => [];
  #done = 0;
  #isDue = false;

  /**
   * @param later runs a function after a delay; results in between are displayed together
   * @param nameMaze names the maze of a run that is watched, in the language of the page
   */
  constructor(
    pool: WorkerPool,
    later: (show: () => void) => void,
    nameMaze: (task: LessonTask, maze: number) => string,
  ) {
    this.#pool = pool;
    this.#later = later;
    this.#nameMaze = nameMaze;
  }

  start(tasks: readonly ChosenTask[], entries: readonly HandInEntry[]): void {
    const { subjects, rowsOf } = prepare(tasks, entries);
    this.#subjects = subjects;
    this.#rowsOf = rowsOf;
    this.#changed = new Set();
    this.#done = 0;
    const groups = tasks.map((task) =>
      subjects.filter((each) => each.task === task && each.violation === null),
    );
    const job: CheckJob = {
      checks: tasks.map(({ task }, at) => ({
        task,
        attempts: (groups[at] ?? []).map(({ attempt }) => attempt),
      })),
    };
    const count = countCheckUnits(job);
    const state = count === 0 ? "done" : "running";
    this.store.setState({ state, done: 0, count, rows: rowsOf() });
    this.#pool.run({ kind: "check", check: job }, count, {
      onResult: (result, unit) => {
        if (result.kind !== "check") return;
        const { check, attempt, maze } = checkUnitAt(job, unit);
        const subject = groups[check]?.[attempt];
        if (subject === undefined) return;
        subject.outcomes[maze] = result.outcome;
        this.#changed.add(subject);
        this.#done++;
        this.#showSoon(count);
      },
      onEnd: (reason) => {
        if (reason === "failed") this.store.setState({ state: "failed" });
      },
    });
  }

  /** Ends the check; the results so far stay. */
  stop(): void {
    if (this.store.getState().state !== "running") return;
    this.#pool.stop();
    this.#show();
    this.store.setState({ state: "stopped" });
    void this.#record();
  }

  /** Ends the check, and deletes its results. */
  clear(): void {
    this.#pool.stop();
    this.#subjects = [];
    this.store.setState(idle);
  }

  #showSoon(count: number): void {
    if (this.#done === count) {
      this.#show();
      this.store.setState({ state: "done" });
      void this.#record();
      return;
    }
    if (this.#done === 1) return this.#show();
    if (this.#isDue) return;
    this.#isDue = true;
    this.#later(() => {
      this.#isDue = false;
      if (this.store.getState().state === "running") this.#show();
    });
  }

  #show(): void {
    for (const subject of this.#changed) decide(subject);
    this.#changed.clear();
    this.store.setState({ done: this.#done, rows: this.#rowsOf() });
  }

  /** Records the first failed run of each attempt, so that it can be watched. */
  async #record(): Promise<void> {
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
      return [{ subject, run }];
    });
    await recordRuns(
      this.#pool,
      failed.map(({ run }) => run),
      (written, at) => {
        const each = failed[at];
        if (each === undefined || this.#subjects !== subjects) return;
        each.subject.watch = watchAddress(each.run, written);
        this.#changed.add(each.subject);
        this.#later(() => {
          if (this.#subjects === subjects && this.#changed.size > 0) this.#show();
        });
      },
    );
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
