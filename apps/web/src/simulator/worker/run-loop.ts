/**
 * The run: driver, clock, speed and displayed tick. `updates` is what the page receives from it.
 *
 * It depends on neither timers nor sockets nor the worker: the entry calls `advance` as real time
 * passes and forwards messages. Speed changes how many ticks run, never what happens in one. While
 * an earlier tick is displayed, the live run waits.
 */
import type { ProgramDocument } from "@corridor/program";
import type { DeliveredCommand, DriverName, Snapshot } from "@corridor/protocol";
import type { MazeDocument } from "@corridor/maze";
import type { Recording, WrittenRun } from "@corridor/recording";
import type { CancelReason } from "../protocol/cancel-reason.ts";
import { commandOfKey } from "../drivers/hand-driver.ts";
import type { RemoteDriver, RemoteRobot } from "../drivers/remote-driver.ts";
import { LiveRun } from "./live-run.ts";
import { RunClock } from "./run-clock.ts";
import { RunObserver } from "./run-observer.ts";
import { DisplayedTick } from "./displayed-tick.ts";
import { isChangeOfDecision } from "./change-of-decision.ts";
import { RunUpdates } from "./run-updates.ts";
import type { DriveKey, Speed, StepLength } from "../protocol/worker-messages.ts";

export class RunLoop {
  #remote: RemoteDriver | null = null;
  readonly #clock: RunClock;
  readonly #observer = new RunObserver();
  readonly #live: LiveRun;
  readonly #screen: DisplayedTick;
  /** changes for the page */
  readonly updates: RunUpdates;
  /** a script's robot continues as soon as the newest tick is displayed again */
  #resumesNow = false;
  /** pause after the next tick, or at the next change of decision */
  #stepping: StepLength | null = null;
  #isSuspended = false;
  /** continues what the suspension interrupted; null: nothing drove, or it has ended since */
  #continue: (() => void) | null = null;

  /** @param now monotonic milliseconds since 1970, comparable over a reload */
  constructor(maze: MazeDocument, program: ProgramDocument, now: () => number) {
    this.#clock = new RunClock(now);
    this.#live = new LiveRun(maze, program, now);
    this.#screen = new DisplayedTick(this.#live);
    this.updates = new RunUpdates(this.#live, this.#screen, this.#observer);
  }

  /** Enables driving by scripts, whose code loads on demand. */
  connect(driverOf: (robot: () => RemoteRobot) => RemoteDriver): void {
    this.#remote = driverOf(() => this.recording);
  }

  /** the commands of scripts; they arrive by `accept`, and all end by `cancelRemote` */
  get remote(): Pick<RemoteDriver, "cancelOne" | "reset" | "renew" | "running"> | null {
    return this.#remote;
  }

  /** when the run began or was opened, in ms since 1970 */
  get startedAt(): number {
    return this.#live.startedAt;
  }

  /** Whether the robot is unchanged since the page started, and nothing drives it. */
  get isUntouched(): boolean {
    const { revision, run, isRunning } = this.#live;
    return revision === 0 && run.tick === 0 && !isRunning;
  }

  /** The live run, for storing it. */
  get recording(): Recording {
    return this.#live.recording;
  }

  /** Whether these are the open documents. */
  isOf(maze: MazeDocument, program: ProgramDocument): boolean {
    return this.#live.isOf(maze, program);
  }

  /** Whether simulated time passes, live or in a playback. */
  get isRunning(): boolean {
    return this.#live.isRunning || this.#screen.isPlaying;
  }

  /** The driver at the newest tick. */
  get driver(): DriverName {
    return this.#live.driver;
  }

  /** The robot stays where it is; without room it is moved to its start, which starts a new run. */
  editMaze(maze: MazeDocument): void {
    if (!this.#live.editMaze(maze)) return;
    this.now();
    this.updates.changed();
    if (this.#live.run.tick > 0 && this.#live.applyMaze()) return;
    this.#remote?.cancel("mazeChanged");
    this.#startRun();
  }

  /** While the past is displayed, the run receives the new program only when it continues. */
  editProgram(program: ProgramDocument): void {
    this.#live.editProgram(program);
    if (!this.#screen.isPast) this.#live.bringProgram();
    this.updates.changed();
  }

  /** Starts the clock, from the displayed tick on; if a user drove, the program takes over. */
  run(): void {
    this.#truncateHere();
    if (this.driver === "me") this.setDriver("program");
    this.#stepping = null;
    this.#start();
  }

  pause(): void {
    this.#screen.pause();
    this.#live.isRunning = false;
    this.#stepping = null;
    this.#resumesNow = false;
    this.#continue = null;
    this.updates.changed();
  }

  /**
   * Pauses; until it ends, nothing starts the clock: no button, script or playback. Then the same
   * run continues, but a drive by hand waits for its next key.
   */
  suspend(isSuspended: boolean): void {
    if (isSuspended === this.#isSuspended) return;
    this.#isSuspended = isSuspended;
    const resume = isSuspended ? this.#interrupted() : null;
    if (isSuspended) this.pause();
    else this.#continue?.();
    this.#continue = resume;
  }

  /**
   * Continues to the next change of decision and pauses: another line decides, or a manoeuvre
   * starts or ends. A bump and a standing robot end the step, too. In the past, the recorded change
   * is displayed.
   */
  step(length: StepLength = "decision"): void {
    if (this.#screen.isPast) {
      if (length === "tick") this.seek(this.#screen.tick + 1);
      else this.seekStep(1);
      return;
    }
    this.run();
    this.#stepping = length;
  }

  /** Moves the robot to its start; maze, program, driver and speed stay. Starts a new run. */
  reset(): void {
    this.#remote?.cancel("reset");
    this.#startRun();
  }

  setSpeed(speed: Speed): void {
    this.#clock.speed = speed;
  }

  /** Changes the driver and stops the robot; a script's robot is live at once, the others wait. */
  setDriver(driver: DriverName): void {
    this.now();
    if (driver === this.driver) return;
    if (this.driver === "remote") this.#remote?.cancel("takenOver");
    this.recording.addInput({ do: "driver", driver });
    this.pause();
    if (driver === "remote") this.#start();
  }

  /** Changes the driver of a robot that waits at its start; a run that has started continues. */
  offerDriver(driver: DriverName): void {
    if (this.#live.run.tick > 0 || this.#live.isRunning || this.driver !== "program") return;
    this.setDriver(driver);
  }

  /** A drive key is pressed or released; the user drives from now on, from the displayed tick. */
  hold(key: DriveKey): void {
    const isLettingGo = key === "stop";
    // The key that was held until now counts up to this tick.
    this.advance();
    if (isLettingGo && (this.driver !== "me" || this.#screen.isPast)) return;
    this.#truncateHere();
    this.setDriver("me");
    this.recording.addInput({ do: "command", command: commandOfKey(key) });
    if (isLettingGo) this.pause();
    else this.#start();
  }

  /**
   * Accepts a remote command; if Remote does not drive, the command ends at once. A script drives
   * live: the newest tick is displayed again.
   */
  accept(delivery: DeliveredCommand): void {
    this.#remote?.accept(delivery);
    if (this.driver === "remote") this.now();
    else this.#remote?.cancel("notRemote");
    this.updates.changed();
  }

  /** Ends running and queued remote commands, and stops the robot. */
  cancelRemote(reason: CancelReason): void {
    if (this.driver !== "remote") return;
    this.#remote?.cancel(reason);
    this.recording.addInput({ do: "cancel" });
    this.updates.changed();
  }

  /** Displays the state at the end of a tick; the live run waits. */
  seek(tick: number): void {
    this.#waitForPast();
    this.#screen.seek(tick);
    if (this.#screen.isAtEnd) this.now();
  }

  /** Displays the previous or next decision; after the newest, takes the next one. */
  seekStep(by: 1 | -1): void {
    if (by === 1 && !this.#screen.isPast) {
      this.step();
      return;
    }
    this.#waitForPast();
    this.#screen.seekStep(by);
    if (this.#screen.isAtEnd) this.now();
  }

  /** Plays the recording from the displayed tick up to the newest. */
  play(): void {
    if (!this.#screen.isPast || this.#isSuspended) return;
    this.#screen.play();
    this.#startClock();
  }

  /** Displays the newest tick again; the run receives a program that was edited meanwhile. */
  now(): void {
    if (!this.#screen.isPast) return;
    this.#screen.leavePast();
    this.updates.changed();
    this.#live.bringProgram();
    if (this.#resumesNow) this.#start();
  }

  /** The run so far as a document. */
  saveRun(): WrittenRun {
    return this.recording.toDocument(this.#live.maze.name);
  }

  /**
   * Displays another run where it ended, paused.
   * @returns its last documents
   */
  open(recording: Recording): { ok: true; maze: MazeDocument; program: ProgramDocument } {
    this.#remote?.cancel("movedInTime");
    this.#live.open(recording);
    this.#started();
    const { maze, program } = this.#live;
    // The commands of the script ended long ago, so Remote has to be chosen again.
    if (this.driver === "remote") this.setDriver("program");
    return { ok: true, maze, program: program.document };
  }

  /** Runs the ticks for the real time since the last call. */
  advance(): void {
    this.#remote?.update();
    if (this.driver === "remote" && this.#live.isRunning)
      this.#remote?.takeReset(() => this.#startRun());
    const isAtSpeed = !this.#isByHand && !this.#isAwaitingScript;
    const flow = !this.isRunning ? "standing" : isAtSpeed ? "at-speed" : "real-time";
    this.#clock.advance(flow, (count) => this.#runTicks(count, isAtSpeed));
  }

  get #isByHand(): boolean {
    return this.driver === "me" && !this.#screen.isPast;
  }

  /** At speed "max", hours would pass while a script computes. */
  get #isAwaitingScript(): boolean {
    return this.driver === "remote" && !this.#screen.isPast && this.#remote?.isIdle !== false;
  }

  /** The newest maze, whichever tick is displayed. */
  get maze(): MazeDocument {
    return this.#live.maze;
  }

  /** The newest state, for scripts; every call has its own seq. */
  snapshot(): Snapshot {
    return this.#screen.newest();
  }

  /** The live run waits while an earlier tick is displayed. */
  #waitForPast(): void {
    if (!this.#screen.isPast) this.#resumesNow = this.#live.isRunning && this.driver === "remote";
    this.#live.isRunning = false;
    this.#stepping = null;
    this.#continue = null;
    this.updates.changed();
  }

  /** Truncates the run at the displayed tick, and applies the newest maze and program. */
  #truncateHere(): void {
    if (!this.#screen.isPast) return;
    const wasRemote = this.driver === "remote";
    const { tick } = this.#screen;
    this.#screen.leavePast();
    this.#resumesNow = false;
    this.updates.changed();
    this.#remote?.cancel("movedInTime");
    this.recording.truncate(tick);
    this.#observer.truncate(this.recording);
    if (!this.#live.applyMaze()) {
      this.#startRun();
      return;
    }
    this.#live.bringProgram();
    if (this.driver !== "remote") return;
    this.recording.addInput(wasRemote ? { do: "cancel" } : { do: "driver", driver: "program" });
  }

  /** What continues after a suspension that begins now. */
  #interrupted(): (() => void) | null {
    if (this.#screen.isPlaying) return () => this.play();
    if (!this.#live.isRunning || this.driver === "me") return null;
    const stepping = this.#stepping;
    return () => {
      this.#start();
      this.#stepping = stepping;
    };
  }

  #start(): void {
    if (this.#isSuspended) return;
    if (!this.#live.isRunning) this.#startClock();
    this.#live.isRunning = true;
  }

  #startClock(): void {
    this.#clock.start();
    this.updates.changed();
  }

  /** @returns whether the clock continues in the same way */
  #runTicks(count: number, isAtSpeed: boolean): boolean {
    if (count > 0) this.updates.changed();
    if (this.#screen.isPast) {
      this.#screen.playOn(count);
      if (this.#screen.isAtEnd) this.now();
      return this.isRunning;
    }
    const flowsOn = (): boolean => this.#live.isRunning && !(isAtSpeed && this.#isAwaitingScript);
    for (let i = 0; i < count && flowsOn(); i++) this.#tick();
    return flowsOn();
  }

  #tick(): void {
    const recording = this.recording;
    const { run } = recording;
    const isRemote = run.driver === "remote";
    if (isRemote) this.#remote?.start();
    this.#observer.before(run);
    const { bumps, pose } = run;
    recording.step();
    const isToWait = this.#observer.after(recording);
    if (isRemote) this.#remote?.finish();
    if (isToWait) this.pause();
    if (this.#stepping === null) return;
    if (this.#stepping === "tick" || isChangeOfDecision(run, { bumps, pose })) this.pause();
  }

  /**
   * Starts a run of the newest documents; the driver stays, and a script's robot is live at once.
   */
  #startRun(): void {
    const { driver } = this;
    this.#live.begin();
    this.#started();
    if (driver === "program") return;
    this.recording.addInput({ do: "driver", driver });
    if (driver === "remote") this.#start();
  }

  /** Another run is the live one now. */
  #started(): void {
    this.#screen.begin();
    this.#observer.begin(this.recording);
    this.pause();
  }
}
