/**
 * Judges the run by the open task: each tick as it runs, and all of them again for another run
 * or after a truncation. Loaded when a lesson opens.
 */
import {
  AttemptJudge,
  termsOf,
  type AttemptTerms,
  type Judgement,
  type Task,
} from "@corridor/challenge";
import type { Recording, Run } from "@corridor/recording";
import { diagnosisTask, type PageTask } from "./diagnosis-task.ts";

const open: Judgement = { kind: "open" };

export class RunJudge {
  readonly #terms: AttemptTerms;
  #judge: AttemptJudge;
  /**
   * met while the clock stood still, which no tick reports; otherwise null. It survives a later
   * truncation.
   */
  #rested: Extract<Judgement, { kind: "met" }> | null = null;
  #reported: Judgement = open;

  readonly #task: Task;

  /** @param maze index of the displayed maze */
  constructor(task: Task, maze: number) {
    this.#task = task;
    this.#terms = termsOf(task, maze);
    this.#judge = new AttemptJudge(this.#terms);
  }

  /**
   * The task of a changed program.
   * @param isWhole whether the program alone drove so far
   */
  task(isWhole: boolean): PageTask {
    return diagnosisTask(this.#task, this.#terms.maze, isWhole);
  }

  /** Whether the run does not meet the task any more. */
  get hasFailed(): boolean {
    return this.#judge.judgement.kind === "failed";
  }

  /** Whether the time of the task ended with the newest tick. */
  isLate({ tick }: Run): boolean {
    const { judgement } = this.#judge;
    return judgement.kind === "failed" && judgement.code === "late" && judgement.tick === tick;
  }

  /** Another run: judges its existing part. */
  begin(recording: Recording): void {
    this.#rested = null;
    this.#rejudge(recording);
  }

  /** The run was truncated at its newest tick. */
  truncate(recording: Recording): void {
    if (this.#rested !== null && this.#rested.tick > recording.run.tick) this.#rested = null;
    this.#rejudge(recording);
  }

  /** A tick is about to run. */
  before(run: Run): void {
    this.#judge.before(run);
  }

  /** The tick has run. */
  after(run: Run): void {
    this.#judge.after(run);
  }

  /** The judgement if it changed since the last call; otherwise null. */
  take(run: Run, isResting: boolean): Judgement | null {
    if (isResting && run.tick > 0 && this.#rested === null) this.#rest(run);
    const judged = this.#rested ?? this.#judge.judgement;
    if (judged === this.#reported) return null;
    // An equal judgement after a repeated one is not reported again.
    const isSame = isSameJudgement(judged, this.#reported);
    this.#reported = judged;
    return isSame ? null : judged;
  }

  #rest(run: Run): void {
    const judge = this.#judge;
    const wasOpen = judge.judgement.kind === "open";
    judge.rest(run);
    const judged: Judgement = judge.judgement;
    if (wasOpen && judged.kind === "met") this.#rested = judged;
  }

  /** The judge needs no more ticks than the task allows, because then it is decided. */
  #rejudge(recording: Recording): void {
    this.#judge = new AttemptJudge(this.#terms);
    if (recording.run.tick === 0) return;
    const playback = recording.playback();
    while (playback.run.tick < recording.run.tick && this.#judge.judgement.kind === "open") {
      this.#judge.before(playback.run);
      playback.step();
      this.#judge.after(playback.run);
    }
  }
}

function isSameJudgement(one: Judgement, other: Judgement): boolean {
  switch (one.kind) {
    case "open":
      return other.kind === "open";
    case "met":
      return (
        other.kind === "met" &&
        one.driver === other.driver &&
        one.tick === other.tick &&
        one.bumps === other.bumps
      );
    case "failed":
      return other.kind === "failed" && one.code === other.code && one.tick === other.tick;
  }
}
