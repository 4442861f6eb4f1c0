/**
 * Runs every claimed solution again: a student's page only reports that a task is solved. The first
 * claim that passes counts.
 */
import {
  violationOf,
  type Attempt,
  type LessonDocument,
  type MazeOutcome,
} from "@corridor/challenge";
import { handInsOf } from "@corridor/link";
import type { ClaimedSolution, SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import type { WorkerPool } from "../../simulator/worker-pool.ts";
import { resultOf } from "../check/attempt-result.ts";
import { PoolCheck, type Later } from "../check/pool-check.ts";

export type Verification =
  | { kind: "checking" }
  | { kind: "passes"; claim: CodedClaim; attempt: Attempt }
  /** no claim passes, and the newest has no code */
  | { kind: "unchecked" }
  /** no claim passes */
  | { kind: "fails" };

/** A claim that a dashboard can run again. */
export type CodedClaim = ClaimedSolution & { code: string };

/** By student and task. */
export type Verifications = ReadonlyMap<number, ReadonlyMap<number, Verification>>;

/** The result of a claim, for all students who make it. */
type Result = { passes: boolean; attempt: Attempt | null };

interface Job {
  /** task and code */
  key: string;
  /** from 1 */
  task: number;
  attempt: Attempt;
}

export class SolutionVerifier {
  readonly #check: PoolCheck;
  readonly #changed: (verifications: Verifications) => void;
  #lesson: LessonDocument | null = null;
  #students: ReadonlyMap<number, Pick<SeenStudent, "tasks">> = new Map();
  #results = new Map<string, Result | "other-lesson">();
  #queue: Job[] = [];

  constructor(
    pool: Pick<WorkerPool, "run" | "stop">,
    later: Later,
    changed: (verifications: Verifications) => void,
  ) {
    this.#check = new PoolCheck(pool, later);
    this.#changed = changed;
  }

  /** Follows the claims of the students. Codes of another lesson do not count. */
  follow(lesson: LessonDocument, students: ReadonlyMap<number, Pick<SeenStudent, "tasks">>): void {
    this.#students = students;
    if (lesson !== this.#lesson) {
      this.#lesson = lesson;
      this.#check.stop();
      this.#queue = [];
      this.#results.clear();
    }
    for (const { tasks } of students.values()) {
      for (const { task, claims } of tasks)
        for (const { code } of claims) if (code !== null) this.#add(task, code);
    }
    this.#publish();
    this.#next();
  }

  #add(task: number, code: string): void {
    const key = keyOf(task, code);
    const lesson = this.#lesson;
    const isQueued = this.#queue.some((job) => job.key === key);
    if (lesson === null || this.#results.has(key) || isQueued) return;
    const lines = handInsOf(code, lesson);
    const read = lines.ok ? lines.value[0]?.read : undefined;
    const document = lesson.tasks[task - 1];
    if (read?.ok === false && read.code === "other-lesson") {
      this.#results.set(key, "other-lesson");
      return;
    }
    const isReadable = read?.ok === true && (read.value.task ?? task - 1) === task - 1;
    if (!isReadable || document === undefined) {
      this.#results.set(key, { passes: false, attempt: null });
      return;
    }
    const { attempt } = read.value;
    if (violationOf(document, attempt) !== null) {
      this.#results.set(key, { passes: false, attempt });
      return;
    }
    this.#queue.push({ key, task, attempt });
  }

  /** Runs the next claim, unless one runs. */
  #next(): void {
    const [job] = this.#queue;
    const task = this.#lesson?.tasks[(job?.task ?? 0) - 1];
    if (job === undefined || task === undefined || this.#check.isRunning) return;
    const outcomes: (MazeOutcome | undefined)[] = [];
    this.#check.start(
      { checks: [{ task, attempts: [job.attempt] }] },
      {
        onOutcome: ({ maze }, outcome) => (outcomes[maze] = outcome),
        onShow: () => undefined,
        onEnd: (reason) => {
          this.#queue = this.#queue.filter((each) => each !== job);
          const { verdict } = resultOf(task, job.attempt, null, outcomes);
          const passes = verdict === "all" || verdict === "enough";
          // Without its workers, the page cannot verify anything: the claim stays open.
          if (reason === "failed") this.#queue.push(job);
          else this.#results.set(job.key, { passes, attempt: job.attempt });
          this.#publish();
          if (reason === "done") this.#next();
        },
      },
    );
  }

  #publish(): void {
    const verifications = new Map<number, Map<number, Verification>>();
    for (const [student, { tasks }] of this.#students) {
      const own = new Map<number, Verification>();
      for (const { task, claims } of tasks) {
        const verification = this.#verificationOf(task, claims);
        if (verification !== null) own.set(task, verification);
      }
      if (own.size > 0) verifications.set(student, own);
    }
    this.#changed(verifications);
  }

  #verificationOf(task: number, claims: readonly ClaimedSolution[]): Verification | null {
    let newest: Verification | null = null;
    let isOpen = false;
    for (const { code, ...claim } of claims) {
      if (code === null) {
        newest = { kind: "unchecked" };
        continue;
      }
      const result = this.#results.get(keyOf(task, code));
      if (result === "other-lesson") continue;
      if (result === undefined) isOpen = true;
      else if (result.passes && result.attempt !== null) {
        return { kind: "passes", claim: { ...claim, code }, attempt: result.attempt };
      } else newest = { kind: "fails" };
    }
    return isOpen ? { kind: "checking" } : newest;
  }
}

function keyOf(task: number, code: string): string {
  return `${task} ${code}`;
}
