/**
 * Who watches the live run tick by tick: notes what is worth telling, what the coach has to say and how
 * an attempt at a challenge stands, and says when the robot waits for the reader.
 */
import type { Judgement } from "@corridor/challenge";
import type { LoopNotice } from "@corridor/coach";
import type { DriverName, LineRef } from "@corridor/protocol";
import type { Recording, Run } from "@corridor/recording";
import { Moments } from "./moments.ts";
import { RunCoach } from "./run-coach.ts";
import type { RunJudge } from "./run-judge.ts";
import type { Moment } from "./worker-messages.ts";

export class RunWatch {
  readonly #moments = new Moments();
  readonly #coach = new RunCoach();
  #notice: LoopNotice | null = null;
  /** the last tick that stays of what was told before; null while all of it does */
  #forgottenAfter: number | null = null;
  /** null while no challenge is open */
  #judge: RunJudge | null = null;
  /** the run before the tick */
  #bumps = 0;
  #goalTick: number | null = null;
  #driver: DriverName = "program";
  #line: LineRef | null = null;

  /** Judges the run by a challenge from its first tick on; null: by none. */
  judgeBy(judge: RunJudge | null, recording: Recording): void {
    this.#judge = judge;
    judge?.begin(recording);
  }

  /** Another run. */
  begin(recording: Recording): void {
    this.#forgetAfter(-1);
    this.#judge?.begin(recording);
  }

  /** The run forgot what came after its newest moment. */
  cut(recording: Recording): void {
    this.#forgetAfter(recording.run.tick);
    this.#judge?.cut(recording);
  }

  /** A tick is about to run. */
  before(run: Run): void {
    this.#bumps = run.bumps;
    this.#goalTick = run.goalTick;
    this.#driver = run.driver;
    this.#line = run.line;
    this.#judge?.before(run);
  }

  /** The tick has run. @returns whether the robot waits for the reader now */
  after(recording: Recording): boolean {
    const { run } = recording;
    this.#judge?.after(run);
    const line = this.#line;
    const driver = this.#driver;
    if (driver === "program" && line !== null) this.#notice ??= this.#coach.look(run, line);
    const isExplained = run.bumps > this.#bumps && this.#bumped(recording);
    if (run.goalTick === this.#goalTick) return isExplained;
    this.#moments.add("goal", run, line, driver);
    // A script decides for itself what comes after the goal; under a hand the robot rests there like a program's.
    return isExplained || driver !== "remote";
  }

  takeMoments(): Moment[] {
    return this.#moments.take();
  }

  /** That the program's robot gets nowhere; null when there is nothing to say since the last call. */
  takeNotice(): LoopNotice | null {
    const notice = this.#notice;
    this.#notice = null;
    return notice;
  }

  /** After which tick all that was told before is forgotten; null where nothing is since the last call. */
  takeForgottenAfter(): number | null {
    const after = this.#forgottenAfter;
    this.#forgottenAfter = null;
    return after;
  }

  /** How the attempt at the challenge stands; null where that did not change since the last call. */
  takeJudgement(run: Run, isResting: boolean): Judgement | null {
    return this.#judge?.take(run, isResting) ?? null;
  }

  /** A program's bump is explained, and the robot waits meanwhile; once a line, or nobody could run on. */
  #bumped(recording: Recording): boolean {
    const line = this.#line;
    const driver = this.#driver;
    const isProgram = driver === "program" && line !== null;
    const explained = isProgram ? this.#coach.explain(recording, line) : null;
    this.#moments.add("bump", recording.run, line, driver, explained);
    return explained !== null;
  }

  /** What happened later is no part of the run: nobody tells it, and what was said of it may be said again. */
  #forgetAfter(tick: number): void {
    this.#forgottenAfter = Math.min(this.#forgottenAfter ?? tick, tick);
    this.#moments.forgetAfter(tick);
    this.#coach.begin();
    this.#notice = null;
  }
}
