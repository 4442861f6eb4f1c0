/**
 * Observes the live run tick by tick: collects events, diagnoses and judgements, and decides when
 * the robot waits for the student.
 */
import type { Judgement } from "@corridor/challenge";
import type { LoopNotice } from "@corridor/coach";
import type { DriverName, LineRef } from "@corridor/protocol";
import type { Recording, Run } from "@corridor/recording";
import { RunEvents } from "./run-events.ts";
import type { DiagnosedRun, TaskOf } from "./diagnose-run.ts";
import { RunDiagnosis, type Diagnostics } from "./run-diagnosis.ts";
import type { RunJudge } from "./run-judge.ts";
import type { RunEvent } from "../protocol/worker-messages.ts";

/** The program does not reach the goal, since this tick. */
interface NoGoal {
  failure: "late" | LoopNotice;
  tick: number;
}

export class RunObserver {
  readonly #events = new RunEvents();
  readonly #coach = new RunDiagnosis();
  #diagnosed: DiagnosedRun | null = null;
  /** pending until the diagnostics load: a robot that gets nowhere, and a bump */
  #noGoal: NoGoal | null = null;
  #waiting: { tick: number; line: LineRef | null; driver: DriverName } | null = null;
  /** whether the diagnostics module is loading */
  #isLoading = false;
  /** the tick after which reported events were truncated; null without a truncation */
  #truncatedAfter: number | null = null;
  /** null without a challenge */
  #judge: RunJudge | null = null;
  /** state of the run before the tick */
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
    this.#truncate(-1);
    this.#judge?.begin(recording);
  }

  /** The run was truncated at its newest tick. */
  truncate(recording: Recording): void {
    this.#reportUnexplained(recording.run);
    this.#truncate(recording.run.tick);
    this.#judge?.truncate(recording);
  }

  /** A tick is about to run. */
  before(run: Run): void {
    this.#reportUnexplained(run);
    this.#bumps = run.bumps;
    this.#goalTick = run.goalTick;
    this.#driver = run.driver;
    this.#line = run.line;
    this.#isWaiting = run.decision.action === "stop";
    this.#judge?.before(run);
  }

  /**
   * The tick has run.
   * @returns whether the robot waits for the user now
   */
  after(recording: Recording): boolean {
    const { run } = recording;
    this.#judge?.after(run);
    const line = this.#line;
    const driver = this.#driver;
    const isOver = driver === "program" && line !== null && this.#detectNoGoal(recording, line);
    const isExplained = run.bumps > this.#bumps && this.#bumped(recording);
    if (run.goalTick === this.#goalTick) return isExplained || isOver;
    this.#events.add("goal", run, line, driver);
    // A script decides by itself after the goal; a robot that a user drives rests there like a
    // program's.
    return isExplained || driver !== "remote";
  }

  takeEvents(): RunEvent[] {
    return this.#events.take();
  }

  /**
   * Why the program's robot does not reach the goal; null without a new diagnosis since the last
   * call.
   */
  takeDiagnosed(): DiagnosedRun | null {
    const diagnosed = this.#diagnosed;
    this.#diagnosed = null;
    return diagnosed;
  }

  /**
   * The tick after which reported events were truncated since the last call; null without a
   * truncation.
   */
  takeTruncatedAfter(): number | null {
    const after = this.#truncatedAfter;
    this.#truncatedAfter = null;
    return after;
  }

  /**
   * The judgement of the challenge if it changed since the last call; otherwise null. A failed run
   * is reported with its explanation, which may still load.
   */
  takeJudgement(run: Run, isResting: boolean): Judgement | null {
    const isExplaining = this.#waiting !== null || (this.#isLoading && this.#noGoal !== null);
    if (isExplaining && this.#judge?.hasFailed === true) return null;
    return this.#judge?.take(run, isResting) ?? null;
  }

  /**
   * A program's bump is explained while the robot waits; once per line, so that the user can
   * continue. While the diagnostics load, the bump waits for them: reported twice, it would get two
   * verdicts.
   */
  #bumped(recording: Recording): boolean {
    const line = this.#line;
    const driver = this.#driver;
    const explained = this.#coach.bump(recording, driver, line, this.#task);
    if (explained === "later" && this.#isLoading) {
      this.#waiting = { tick: recording.run.tick, line, driver };
    } else {
      const diagnosed = explained === "later" ? null : explained;
      this.#events.add("bump", recording.run, line, driver, diagnosed);
    }
    return explained !== null && driver === "program";
  }

  /** The diagnostics module is loading, or could not be loaded. */
  awaitDiagnostics(isLoading: boolean, run: Run): void {
    this.#isLoading = isLoading;
    if (!isLoading) this.#reportUnexplained(run);
  }

  /** The diagnostics module has loaded: explains the bump at which the robot waits. */
  useDiagnostics(diagnostics: Diagnostics, recording: Recording): void {
    this.#isLoading = false;
    this.#coach.use(diagnostics);
    if (this.#noGoal !== null) this.#diagnoseNoGoal(recording, this.#noGoal);
    const waiting = this.#waiting;
    this.#waiting = null;
    const { run } = recording;
    if (waiting === null || waiting.tick !== run.tick) return;
    const { line, driver } = waiting;
    const cause = driver === "program" ? line : null;
    const explained = this.#coach.explain(recording, cause, this.#task);
    this.#events.add("bump", run, line, driver, explained === "later" ? null : explained);
  }

  /** The robot does not wait for an explanation any more, so its bump is reported without one. */
  #reportUnexplained(run: Run): void {
    const waiting = this.#waiting;
    this.#waiting = null;
    if (waiting === null || waiting.tick !== run.tick) return;
    this.#events.add("bump", run, waiting.line, waiting.driver);
  }

  /** @returns whether the time of the challenge ends with this tick */
  #detectNoGoal(recording: Recording, line: LineRef): boolean {
    const { run } = recording;
    const notice = this.#coach.observe(run, line, this.#isWaiting);
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

  /** Discards later events; their explanations may be repeated. */
  #truncate(tick: number): void {
    this.#truncatedAfter = Math.min(this.#truncatedAfter ?? tick, tick);
    this.#events.truncate(tick);
    this.#coach.begin();
    this.#diagnosed = null;
    this.#waiting = null;
    this.#noGoal = null;
  }
}
