/**
 * Detects the runs of a student in the messages of the worker: where one begins and ends, its bumps,
 * and why it failed. A run ends at a bump that stops the program, at the goal, when the time is over,
 * when the robot is reset, or when the past replaces it. Pause and resume belong to one run.
 */
import { CELL } from "@corridor/maze";
import { MAX_BUMP_PLACES, type DriverName, type Pose, type Progress } from "@corridor/protocol";
import type { FromWorker } from "../../simulator/protocol/worker-messages.ts";

type RunRecord = Extract<Progress, { kind: "run" }>;
export type AttemptFailure = RunRecord["failure"];

export interface FinishedRun extends Pick<
  RunRecord,
  "bumps" | "bumpPlaces" | "mistakes" | "failure"
> {
  /** the program that drove, as a text to compare; null: a drive by hand or by a script */
  program: string | null;
}

export interface RunAttemptsPorts {
  /** the newest program as a text to compare */
  program: () => string;
  /** the displayed maze of the task, as in tiles; null: another one */
  maze: () => string | null;
  onFinished: (run: FinishedRun) => void;
  /** @returns a function that cancels the call */
  later: (call: () => void, ms: number) => () => void;
}

/** The explanation of a failed run may follow its end after this time at the latest, in ms. */
const EXPLAINED_MS = 1_000;

type FrameMessage = Extract<FromWorker, { type: "frame" }>;

export class RunAttempts {
  readonly #ports: RunAttemptsPorts;
  /** null: no run has begun since the last one ended */
  #run: FinishedRun | null = null;
  #lastTick: number;
  /** bumps at the newest tick; null: unknown after a jump */
  #bumps: number | null;
  /** where the robot is at the newest tick, as a text to compare; null: not known */
  #place: string | null = null;
  /** since the last tick that was driven */
  #isEdited = false;
  /** a failed drive may continue, but it is one run until the robot is reset */
  #isDriveOver = false;
  /**
   * the next frame may show a run that was opened, not driven: another one, or the one that a reload
   * has just restored
   */
  #isOpened = true;
  /** another task is open, and the worker has not ended the run of the one before yet */
  #isBeforeReset = false;
  /** cancels the report of a run that has ended; null: it has not */
  #cancelEnd: (() => void) | null = null;

  /** @param tick of the live run, which continues */
  constructor(ports: RunAttemptsPorts, { tick, bumps }: { tick: number; bumps: number }) {
    this.#ports = ports;
    this.#lastTick = tick;
    this.#bumps = bumps;
  }

  receive(message: FromWorker): void {
    if (message.type === "truncated" && message.after < 0) this.#isBeforeReset = false;
    if (this.#isBeforeReset) return;
    if (message.type === "frame") this.#frame(message.frame);
    else if (message.type === "truncated") this.#truncated(message.after);
    else if (message.type === "run-loaded" && message.loaded.ok) {
      this.discard();
      this.#isOpened = true;
    } else if (message.type === "event") {
      // It may arrive before the frame of its tick.
      const { kind, driver, line, tick, bumps, pose } = message.event;
      this.#advance(tick, bumps, driver);
      if (kind === "bump") this.#bumped(pose);
      if (kind === "bump" && driver === "program") this.failed({ code: "bump", line }, 0, tick);
    }
  }

  /**
   * Why the run fails is known. The newest reason counts.
   * @param tick at which it failed
   */
  failed(failure: NonNullable<AttemptFailure>, mistakes: number, tick: number): void {
    if (this.#isBeforeReset) return;
    // At full speed, a whole run fits between two frames.
    if (tick > this.#lastTick) this.#advance(tick, null, "program");
    const run = this.#run;
    if (run === null) return;
    run.failure = { ...failure, line: failure.line ?? run.failure?.line ?? null };
    run.mistakes = Math.max(mistakes, run.mistakes);
    if (run.program === null) this.#endDrive();
    else if (failure.code === "late") this.#endSoon();
  }

  /** The run reached what the task asks for in this maze. */
  met(): void {
    const run = this.#run;
    if (run === null) return;
    Object.assign(run, { failure: null, mistakes: 0 });
    if (run.program === null) this.#endDrive();
    else this.finish();
  }

  /** The program was edited: a run that failed ends, and another one continues with the edit. */
  edited(): void {
    const hasFailed = this.#run !== null && this.#run.failure !== null;
    if (hasFailed || this.#cancelEnd !== null) this.finish();
    this.#isEdited = true;
  }

  /** Another task opens. What still arrives of the run before belongs to no run of this task. */
  awaitReset(): void {
    this.#isBeforeReset = true;
  }

  /** Ends the run and reports it, if there is one. */
  finish(): void {
    const run = this.#run;
    this.discard();
    if (run !== null) this.#ports.onFinished(run);
  }

  /** Ends the run without a report. */
  discard(): void {
    this.#cancelEnd?.();
    this.#cancelEnd = null;
    this.#run = null;
  }

  #endDrive(): void {
    this.finish();
    this.#isDriveOver = true;
  }

  #frame({ snapshot, hasEnded, view, nowTick, nowDriver }: FrameMessage["frame"]): void {
    if (this.#isOpened && snapshot.state === "paused") this.#lastTick = nowTick;
    this.#isOpened = false;
    const hasMoved = view === "now" && this.#hasMoved(snapshot.pose);
    if (nowDriver === "remote" && !hasMoved) this.#lastTick = nowTick;
    this.#advance(nowTick, view === "now" ? snapshot.bumps : null, nowDriver);
    const isEnd = view === "now" && hasEnded && snapshot.state === "paused";
    if (isEnd && this.#run !== null && this.#run.program !== null) this.#endSoon();
  }

  /** Time passes while a robot waits for a script, which is no run yet. */
  #hasMoved({ x, y, heading }: Pose): boolean {
    const before = this.#place;
    this.#place = `${x} ${y} ${heading}`;
    return before !== null && this.#place !== before;
  }

  /** @param bumps up to this tick; null: not known */
  #advance(tick: number, bumps: number | null, driver: DriverName): void {
    const hasDriven = tick > this.#lastTick;
    this.#lastTick = tick;
    if (hasDriven) this.#drive(driver);
    if (bumps === null) return;
    if (this.#run !== null) this.#run.bumps += Math.max(0, bumps - (this.#bumps ?? bumps));
    this.#bumps = bumps;
  }

  #bumped({ x, y }: Pick<Pose, "x" | "y">): void {
    const maze = this.#ports.maze();
    const places = this.#run?.bumpPlaces ?? [];
    if (this.#run === null || maze === null || places.length >= MAX_BUMP_PLACES) return;
    const place = { maze, column: Math.floor(x / CELL), row: Math.floor(y / CELL) };
    this.#run.bumpPlaces = [...places, place];
  }

  #endSoon(): void {
    this.#cancelEnd ??= this.#ports.later(() => this.finish(), EXPLAINED_MS);
  }

  #drive(driver: DriverName): void {
    const isProgram = driver === "program";
    const wasProgram = this.#run?.program !== null;
    // A run that has ended is reported before the next one begins.
    if (this.#cancelEnd !== null || (this.#run !== null && wasProgram !== isProgram)) this.finish();
    if (!isProgram && this.#isDriveOver) return;
    if (this.#run !== null && !this.#isEdited) return;
    this.#isEdited = false;
    const program = isProgram ? this.#ports.program() : null;
    this.#run = { bumps: 0, mistakes: 0, failure: null, ...this.#run, program };
  }

  #truncated(after: number): void {
    this.finish();
    this.#lastTick = Math.max(0, after);
    this.#bumps = after < 0 ? 0 : null;
    this.#place = null;
    this.#isDriveOver = false;
  }
}
