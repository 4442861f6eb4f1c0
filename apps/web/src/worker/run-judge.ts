/**
 * Judges the run by the challenge that is open: each tick as it is driven, and all of them again where the
 * run is another one or begins anew from an earlier moment. Loaded when a challenge opens.
 */
import {
  AttemptJudge,
  termsOf,
  type AttemptTerms,
  type ChallengeDocument,
  type Judgement,
} from "@corridor/challenge";
import type { DiagnosisTask } from "@corridor/coach";
import type { Recording, Run } from "@corridor/recording";
import { diagnosisTask } from "./diagnosis-task.ts";

const open: Judgement = { kind: "open" };

export class RunJudge {
  readonly #terms: AttemptTerms;
  #judge: AttemptJudge;
  /**
   * met while time stood still, which no tick tells; null when it was not. It stays through a cut after
   * it.
   */
  #rested: Extract<Judgement, { kind: "met" }> | null = null;
  #told: Judgement = open;

  readonly #challenge: ChallengeDocument;
  readonly #maze: number;

  /** @param maze index of the maze on the screen */
  constructor(challenge: ChallengeDocument, maze: number) {
    this.#challenge = challenge;
    this.#maze = maze;
    this.#terms = termsOf(challenge, maze);
    this.#judge = new AttemptJudge(this.#terms);
  }

  /** What a changed program would have to do. @param isWhole whether the program alone drove so far */
  task(isWhole: boolean): DiagnosisTask {
    return diagnosisTask(this.#challenge, this.#maze, isWhole);
  }

  /** Whether the time of the challenge ended with the newest tick. */
  isLate({ tick }: Run): boolean {
    const { judgement } = this.#judge;
    return judgement.kind === "failed" && judgement.code === "late" && judgement.tick === tick;
  }

  /** Another run: judges what there is of it. */
  begin(recording: Recording): void {
    this.#rested = null;
    this.#judgeAgain(recording);
  }

  /** The run forgot what came after its newest moment. */
  cut(recording: Recording): void {
    if (this.#rested !== null && this.#rested.tick > recording.run.tick) this.#rested = null;
    this.#judgeAgain(recording);
  }

  /** A tick is about to run. */
  before(run: Run): void {
    this.#judge.before(run);
  }

  /** The tick has run. */
  after(run: Run): void {
    this.#judge.after(run);
  }

  /** How it stands where that changed since the last call; null where it did not. */
  take(run: Run, isResting: boolean): Judgement | null {
    if (isResting && run.tick > 0 && this.#rested === null) this.#rest(run);
    const judged = this.#rested ?? this.#judge.judgement;
    if (judged === this.#told) return null;
    // One that is judged again is not told again.
    const isSame = JSON.stringify(judged) === JSON.stringify(this.#told);
    this.#told = judged;
    return isSame ? null : judged;
  }

  #rest(run: Run): void {
    const judge = this.#judge;
    const wasOpen = judge.judgement.kind === "open";
    judge.rest(run);
    const judged: Judgement = judge.judgement;
    if (wasOpen && judged.kind === "met") this.#rested = judged;
  }

  /** It takes no more ticks than the challenge gives, since then it is decided. */
  #judgeAgain(recording: Recording): void {
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
