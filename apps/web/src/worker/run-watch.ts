/**
 * Observes the live run tick by tick: collects what is worth reporting, why the run failed and how an
 * attempt at a challenge stands, and decides when the robot waits for the student.
 */
import type { Judgement } from "@corridor/challenge";
import type { LoopNotice } from "@corridor/coach";
import type { DriverName, LineRef } from "@corridor/protocol";
import type { Recording, Run } from "@corridor/recording";
import { Moments } from "./moments.ts";
import type { DiagnosedRun, TaskOf } from "./diagnose-run.ts";
import { RunDiagnosis, type Diagnostics } from "./run-diagnosis.ts";
import type { RunJudge } from "./run-judge.ts";
import type { RunEvent } from "./worker-messages.ts";

/** The program does not get to the goal, since this tick. */
interface NoGoal {
  failure: "late" | LoopNotice;
  tick: number;
}

export class RunWatch {
  readonly #moments = new Moments();
  readonly #coach = new RunDiagnosis();
  #diagnosed: DiagnosedRun | null = null;
  /** what waits for its diagnosis, because the module has not come yet: no way to the goal, and a bump */
  #noGoal: NoGoal | null = null;
  #waiting: { tick: number; line: LineRef | null; driver: DriverName } | null = null;
  /** the last tick that stays of what was told before; null while all of it does */
  #forgottenAfter: number | null = null;
  /** null while no challenge is open */
  #judge: RunJudge | null = null;
  /** the run before the tick */
  #bumps = 0;
  #goalTick: number | null = null;
  #driver: DriverName = "program";
  #line: LineRef | null = null;
  #isWaiting = false;

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
    this.#isWaiting = run.decision.action === "stop";
    this.#judge?.before(run);
  }

  /** The tick has run. @returns whether the robot waits for the reader now */
  after(recording: Recording): boolean {
    const { run } = recording;
    this.#judge?.after(run);
    const line = this.#line;
    const driver = this.#driver;
    const isOver = driver === "program" && line !== null && this.#lookForNoGoal(recording, line);
    const isExplained = run.bumps > this.#bumps && this.#bumped(recording);
    if (run.goalTick === this.#goalTick) return isExplained || isOver;
    this.#moments.add("goal", run, line, driver);
    // A script decides for itself what comes after the goal; under a hand the robot rests there like a program's.
    return isExplained || driver !== "remote";
  }

  takeMoments(): RunEvent[] {
    return this.#moments.take();
  }

  /** Why the program's robot does not get to the goal; null when nothing is new since the last call. */
  takeDiagnosed(): DiagnosedRun | null {
    const diagnosed = this.#diagnosed;
    this.#diagnosed = null;
    return diagnosed;
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
    const explained = this.#coach.bump(recording, driver, line, this.#task);
    const isLater = explained === "later";
    this.#waiting = isLater ? { tick: recording.run.tick, line, driver } : null;
    this.#moments.add("bump", recording.run, line, driver, isLater ? null : explained);
    return explained !== null && driver === "program";
  }

  /** The module that diagnoses has come: explains the bump at which the robot waits. */
  useDiagnostics(diagnostics: Diagnostics, recording: Recording): void {
    this.#coach.use(diagnostics);
    if (this.#noGoal !== null) this.#diagnoseNoGoal(recording, this.#noGoal);
    const waiting = this.#waiting;
    this.#waiting = null;
    const { run } = recording;
    if (waiting === null || waiting.tick !== run.tick) return;
    const { line, driver } = waiting;
    const cause = driver === "program" ? line : null;
    const explained = this.#coach.explain(recording, cause, this.#task);
    if (explained === null || explained === "later") return;
    this.#moments.add("bump", run, line, driver, explained);
  }

  /** @returns whether the time of the challenge is over with this tick */
  #lookForNoGoal(recording: Recording, line: LineRef): boolean {
    const { run } = recording;
    const notice = this.#coach.look(run, line, this.#isWaiting);
    const isLate = this.#judge?.isLate(run) === true;
    const failure = isLate ? "late" : notice;
    if (failure !== null) this.#diagnoseNoGoal(recording, { failure, tick: run.tick });
    return isLate;
  }

  #diagnoseNoGoal(recording: Recording, noGoal: NoGoal): void {
    const { failure, tick } = noGoal;
    const diagnosed = this.#coach.noGoal(recording, failure, tick, this.#task);
    this.#noGoal = diagnosed === "later" ? noGoal : null;
    if (diagnosed !== "later") this.#diagnosed = diagnosed ?? this.#diagnosed;
  }

  get #task(): TaskOf | null {
    const judge = this.#judge;
    return judge && ((isWhole) => judge.task(isWhole));
  }

  /** What happened later is no part of the run: nobody tells it, and what was said of it may be said again. */
  #forgetAfter(tick: number): void {
    this.#forgottenAfter = Math.min(this.#forgottenAfter ?? tick, tick);
    this.#moments.forgetAfter(tick);
    this.#coach.begin();
    this.#diagnosed = null;
    this.#waiting = null;
    this.#noGoal = null;
  }
}
