/**
 * The run: who drives, whether time flows and how fast, which moment is shown, and what the page is
 * told of it.
 *
 * Knows neither timers nor sockets nor the worker it runs in: the entry calls `advance` as real time
 * passes and hands messages in. Speed changes how many ticks run, never what happens in one. What
 * happens is the recording's; while an earlier moment is shown, the live run waits.
 */
import type { Judgement } from "@corridor/challenge";
import type { ProgramDocument } from "@corridor/program";
import type { DeliveredCommand, DriverName, Pose, Snapshot } from "@corridor/protocol";
import type { MazeDocument } from "@corridor/maze";
import type { Recording, TimelineDelta, WrittenRun } from "@corridor/recording";
import type { CancelReason } from "../drivers/cancel-reason.ts";
import { commandOfKey } from "../drivers/hand-driver.ts";
import type { RemoteDriver, RemoteRobot } from "../drivers/remote-driver.ts";
import { LiveRun } from "./live-run.ts";
import { RunClock } from "./run-clock.ts";
import type { DiagnosedRun } from "./diagnose-run.ts";
import type { Diagnostics } from "./run-diagnosis.ts";
import type { RunJudge } from "./run-judge.ts";
import { RunWatch } from "./run-watch.ts";
import { ScreenMoment } from "./screen-moment.ts";
import type { DriveKey, Frame, GhostPose, RunEvent, Speed, StepLength } from "./worker-messages.ts";

/** Where the ghosts of a race are at the end of a tick. */
interface Ghosts {
  posesAt(tick: number): readonly GhostPose[];
}

export class RunLoop {
  #remote: RemoteDriver | null = null;
  /** null while no race is on */
  #ghosts: Ghosts | null = null;
  readonly #clock: RunClock;
  readonly #watch = new RunWatch();
  readonly #live: LiveRun;
  readonly #screen: ScreenMoment;
  /** a script's robot goes on as soon as the newest moment is shown again */
  #resumesNow = false;
  #isRunning = false;
  /** pause after the next tick, or at the next change of decision */
  #stepping: StepLength | null = null;
  #isDirty = true;

  /** @param now monotonic milliseconds */
  constructor(maze: MazeDocument, program: ProgramDocument, now: () => number) {
    this.#clock = new RunClock(now);
    this.#live = new LiveRun(maze, program);
    this.#screen = new ScreenMoment(this.#live);
  }

  /** From now on scripts can drive, which many a visit never needs: what they need for it comes late. */
  connect(driverOf: (robot: () => RemoteRobot) => RemoteDriver): void {
    this.#remote = driverOf(() => this.recording);
  }

  /** the commands of scripts; they come in by `accept`, and all end by `cancelRemote` */
  get remote(): Pick<RemoteDriver, "cancelOne" | "reset" | "renew" | "running"> | null {
    return this.#remote;
  }

  /** Whether nothing has happened to the robot that the page began with. */
  get isUntouched(): boolean {
    return this.#live.revision === 0 && this.#live.run.tick === 0;
  }

  /** The live run, for who stores it. */
  get recording(): Recording {
    return this.#live.recording;
  }

  /** Whether these are the documents that are open. */
  isOf(maze: MazeDocument, program: ProgramDocument): boolean {
    return this.#live.isOf(maze, program);
  }

  /** Whether simulated time flows, live or played again. */
  get isRunning(): boolean {
    return this.#isRunning || this.#screen.isPlaying;
  }

  /** Who drives the newest moment. */
  get driver(): DriverName {
    return this.#live.driver;
  }

  /** The robot stays where it is; one that has no room any more goes to its start, and a new run begins. */
  editMaze(maze: MazeDocument): void {
    if (!this.#live.editMaze(maze)) return;
    this.now();
    this.#isDirty = true;
    if (this.#live.run.tick > 0 && this.#live.bringMaze()) return;
    this.#remote?.cancel("mazeChanged");
    this.#beginRun();
  }

  /** While the past is shown, the run gets the new program only when it goes on. */
  editProgram(program: ProgramDocument): void {
    this.#live.editProgram(program);
    if (!this.#screen.isPast) this.#live.bringProgram();
    this.#isDirty = true;
  }

  /** Lets time flow, from the shown moment on; where nobody but a hand drives, the program takes over. */
  run(): void {
    this.#cutHere();
    if (this.driver === "me") this.setDriver("program");
    this.#stepping = null;
    this.#start();
  }

  pause(): void {
    this.#screen.pause();
    this.#isRunning = false;
    this.#stepping = null;
    this.#resumesNow = false;
    this.#isDirty = true;
  }

  /**
   * Goes on to the next change of decision and pauses: another line decides, or a manoeuvre begins or ends. A bump
   * and a robot that stands end the step as well. In the past, the recorded change is displayed.
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

  /** Robot to start; maze, program, driver and speed stay. A new run begins. */
  reset(): void {
    this.#remote?.cancel("reset");
    this.#beginRun();
  }

  setSpeed(speed: Speed): void {
    this.#clock.speed = speed;
  }

  /** Hands the robot over: it stops; a script's robot is live at once, the others wait. */
  setDriver(driver: DriverName): void {
    this.now();
    if (driver === this.driver) return;
    if (this.driver === "remote") this.#remote?.cancel("handedOver");
    this.recording.addInput({ do: "driver", driver });
    this.pause();
    if (driver === "remote") this.#start();
  }

  /** Hands a robot that waits at its start to another than the program; a run that has begun goes on. */
  offerDriver(driver: DriverName): void {
    if (this.#live.run.tick > 0 || this.#isRunning || this.driver !== "program") return;
    this.setDriver(driver);
  }

  /** A drive key goes down or up; whoever drove before, the hand drives now, from the shown moment on. */
  hold(key: DriveKey): void {
    const isLettingGo = key === "stop";
    // What was held until now counts up to this moment.
    this.advance();
    if (isLettingGo && (this.driver !== "me" || this.#screen.isPast)) return;
    this.#cutHere();
    this.setDriver("me");
    this.recording.addInput({ do: "command", command: commandOfKey(key) });
    if (isLettingGo) this.pause();
    else this.#start();
  }

  /**
   * Takes a remote command; where Remote does not drive, it ends at once and says so. A script drives
   * live: the newest moment is shown again.
   */
  accept(delivery: DeliveredCommand): void {
    this.#remote?.accept(delivery);
    if (this.driver === "remote") this.now();
    else this.#remote?.cancel("notRemote");
    this.#isDirty = true;
  }

  /** Ends what remote commands run and wait, and stops the robot. */
  cancelRemote(reason: CancelReason): void {
    if (this.driver !== "remote") return;
    this.#remote?.cancel(reason);
    this.recording.addInput({ do: "cancel" });
    this.#isDirty = true;
  }

  /** Shows the moment at the end of a tick; the live run waits. */
  seek(tick: number): void {
    this.#waitForPast();
    this.#screen.seek(tick);
    if (this.#screen.isAtEnd) this.now();
  }

  /** Shows the decision before or after the shown moment; after the newest, takes the next one. */
  seekStep(by: 1 | -1): void {
    if (by === 1 && !this.#screen.isPast) {
      this.step();
      return;
    }
    this.#waitForPast();
    this.#screen.seekStep(by);
    if (this.#screen.isAtEnd) this.now();
  }

  /** Plays the recording on from the shown moment up to the newest. */
  play(): void {
    if (!this.#screen.isPast) return;
    this.#screen.play();
    this.#startClock();
  }

  /** Shows the newest moment again; the run gets the program that was edited meanwhile. */
  now(): void {
    if (!this.#screen.isPast) return;
    this.#screen.leavePast();
    this.#isDirty = true;
    this.#live.bringProgram();
    if (this.#resumesNow) this.#start();
  }

  /** The run so far as a document. */
  saveRun(): WrittenRun {
    return this.recording.toDocument(this.#live.maze.name);
  }

  /** Shows another run where it ended, paused. @returns the documents that it ended with */
  open(recording: Recording): { ok: true; maze: MazeDocument; program: ProgramDocument } {
    this.#remote?.cancel("movedInTime");
    this.#live.open(recording);
    this.#begun();
    const { maze, program } = this.#live;
    // A script's commands have ended long ago: Remote is chosen anew.
    if (this.driver === "remote") this.setDriver("program");
    return { ok: true, maze, program: program.document };
  }

  /** Runs the ticks that real time asks for since the last call. */
  advance(): void {
    this.#remote?.update();
    const isAtSpeed = !this.#isByHand && !this.#isAwaitingScript;
    const flow = !this.isRunning ? "standing" : isAtSpeed ? "at-speed" : "real-time";
    this.#clock.advance(flow, (count) => this.#runTicks(count, isAtSpeed));
  }

  get #isByHand(): boolean {
    return this.driver === "me" && !this.#screen.isPast;
  }

  /** At speed "max", hours would pass while a script thinks. */
  get #isAwaitingScript(): boolean {
    return this.driver === "remote" && !this.#screen.isPast && this.#remote?.isIdle !== false;
  }

  /** What there is to draw and to tell since the last call; null when nothing changed. */
  takeNews(): { frame: Frame; moments: RunEvent[]; forgottenAfter: number | null } | null {
    if (!this.#isDirty) return null;
    this.#isDirty = false;
    const frame = this.#screen.frame(this.#isRunning);
    if (this.#ghosts !== null) frame.ghosts = this.#ghosts.posesAt(frame.snapshot.tick);
    const forgottenAfter = this.#watch.takeForgottenAfter();
    return { frame, moments: this.#watch.takeMoments(), forgottenAfter };
  }

  /** From now on frames carry the ghosts of a race, each at the displayed tick. Called again when they change. */
  raceWith(ghosts: Ghosts): void {
    this.#ghosts = ghosts;
    this.#isDirty = true;
  }

  /** The module that says why a run failed has come. */
  useDiagnostics(diagnostics: Diagnostics): void {
    this.#watch.useDiagnostics(diagnostics, this.recording);
    this.#isDirty = true;
  }

  /** Why the program's robot does not get to the goal; null when nothing is new since the last call. */
  takeDiagnosed(): DiagnosedRun | null {
    return this.#watch.takeDiagnosed();
  }

  /** Judges the run by a challenge from its first tick on; null: by none. */
  judgeBy(judge: RunJudge | null): void {
    this.#watch.judgeBy(judge, this.recording);
  }

  /** How the attempt at the challenge stands; null where that did not change since the last call. */
  takeJudgement(): Judgement | null {
    const isResting = !this.#screen.isPast && !this.#isRunning;
    return this.#watch.takeJudgement(this.#live.run, isResting);
  }

  /** What the timeline gained or lost since the last call; null when nothing changed. */
  takeTimeline(): TimelineDelta | null {
    return this.recording.timeline.takeDelta();
  }

  /** The newest maze, whichever moment is shown. */
  get maze(): MazeDocument {
    return this.#live.maze;
  }

  /** The maze of the shown moment where it is not the newest one. */
  get shownMaze(): MazeDocument | null {
    return this.#screen.maze;
  }

  /** The newest moment, for scripts; every call has its own seq. */
  snapshot(): Snapshot {
    return this.#screen.newest(this.#isRunning);
  }

  /** The live run waits while an earlier moment is shown. */
  #waitForPast(): void {
    if (!this.#screen.isPast) this.#resumesNow = this.#isRunning && this.driver === "remote";
    this.#isRunning = false;
    this.#stepping = null;
    this.#isDirty = true;
  }

  /** Forgets what came after the shown moment; what is there now, maze and program, meets the robot. */
  #cutHere(): void {
    if (!this.#screen.isPast) return;
    const wasRemote = this.driver === "remote";
    const { tick } = this.#screen;
    this.#screen.leavePast();
    this.#resumesNow = false;
    this.#isDirty = true;
    this.#remote?.cancel("movedInTime");
    this.recording.truncate(tick);
    this.#watch.cut(this.recording);
    if (!this.#live.bringMaze()) {
      this.#beginRun();
      return;
    }
    this.#live.bringProgram();
    if (this.driver !== "remote") return;
    this.recording.addInput(wasRemote ? { do: "cancel" } : { do: "driver", driver: "program" });
  }

  #start(): void {
    if (!this.#isRunning) this.#startClock();
    this.#isRunning = true;
  }

  #startClock(): void {
    this.#clock.start();
    this.#isDirty = true;
  }

  /** @returns whether time still flows in the same way */
  #runTicks(count: number, isAtSpeed: boolean): boolean {
    if (count > 0) this.#isDirty = true;
    if (this.#screen.isPast) {
      this.#screen.playOn(count);
      if (this.#screen.isAtEnd) this.now();
      return this.isRunning;
    }
    const flowsOn = (): boolean => this.#isRunning && !(isAtSpeed && this.#isAwaitingScript);
    for (let i = 0; i < count && flowsOn(); i++) this.#tick();
    return flowsOn();
  }

  #tick(): void {
    const recording = this.recording;
    const { run } = recording;
    const isRemote = run.driver === "remote";
    if (isRemote) this.#remote?.start();
    this.#watch.before(run);
    const { bumps, pose } = run;
    recording.step();
    const isToWait = this.#watch.after(recording);
    if (isRemote) this.#remote?.finish();
    if (isToWait) this.pause();
    if (this.#stepping === null) return;
    // Readings that stay as they are choose the same line for ever.
    const isStanding = !run.isManoeuvring && isSamePose(run.pose, pose);
    const isChange = run.decidedAt === run.tick || run.bumps !== bumps || isStanding;
    if (isChange || this.#stepping === "tick") this.pause();
  }

  /** A new run of the newest documents; the driver stays, and a script's robot is live at once. */
  #beginRun(): void {
    const { driver } = this;
    this.#live.begin();
    this.#begun();
    if (driver === "program") return;
    this.recording.addInput({ do: "driver", driver });
    if (driver === "remote") this.#start();
  }

  /** Another run is the live one now. */
  #begun(): void {
    this.#screen.begin();
    this.#watch.begin(this.recording);
    this.pause();
  }
}

const isSamePose = (one: Pose, other: Pose): boolean =>
  one.x === other.x && one.y === other.y && one.heading === other.heading;
