/**
 * The run: who drives, whether time flows and how fast, and what the page is told of it.
 *
 * Knows neither timers nor sockets nor the worker it runs in: the entry calls `advance` as real time
 * passes and hands messages in. Speed changes how many ticks run, never what happens in one.
 */
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { DriverName, Snapshot } from "@corridor/protocol";
import type { MazeDocument } from "@corridor/maze";
import { FixedTimestep, ProgramRun, Simulation } from "@corridor/simulation";
import type { CancelReason } from "../drivers/cancel-reason.ts";
import { commandOfKey } from "../drivers/hand-driver.ts";
import { RemoteDriver, type Delivery, type RemoteDriverEvents } from "../drivers/remote-driver.ts";
import { Trail } from "./trail.ts";
import type { DriveKey, Frame, Moment, Speed } from "./worker-messages.ts";

/** At speed "max", ticks between two looks at the clock, and the share of time that may be used. */
const MAX_SPEED_CHUNK = 240;
const MAX_SPEED_BUDGET_MS = 6;

export class RunLoop {
  readonly #now: () => number;
  readonly #timestep = new FixedTimestep();
  readonly #trail = new Trail();
  readonly #remote: RemoteDriver;
  #simulation: Simulation;
  #program: ProgramRun;
  #decider: CompiledProgram;
  #driver: DriverName = "program";
  #isRunning = false;
  /** pause as soon as the decision that is being taken is done */
  #isStepping = false;
  #speed: Speed = 1;
  #lastAt = 0;
  #seq = 0;
  #isDirty = true;
  /** what happened since the last news: the newest bump, and the goal */
  #moments: Moment[] = [];
  #bumpPlaces: number[] = [];

  /** @param now monotonic milliseconds */
  constructor(
    maze: MazeDocument,
    program: ProgramDocument,
    now: () => number,
    remoteEvents: RemoteDriverEvents,
  ) {
    this.#now = now;
    this.#remote = new RemoteDriver(remoteEvents);
    this.#decider = new CompiledProgram(program);
    this.#simulation = new Simulation(maze);
    this.#program = new ProgramRun(this.#simulation, this.#decider);
    this.#beginTrail();
  }

  /** Whether simulated time flows. */
  get isRunning(): boolean {
    return this.#isRunning;
  }

  get driver(): DriverName {
    return this.#driver;
  }

  editMaze(maze: MazeDocument): void {
    this.#isDirty = true;
    if (this.#simulation.tick > 0 && this.#simulation.setMaze(maze)) {
      this.#program.reconsider();
      return;
    }
    this.#remote.cancel(this.#simulation, "mazeChanged");
    this.#simulation = new Simulation(maze);
    this.#program = new ProgramRun(this.#simulation, this.#decider);
    this.#putAtStart();
  }

  editProgram(program: ProgramDocument): void {
    this.#decider = new CompiledProgram(program);
    this.#program.reconsider(this.#decider);
    this.#isDirty = true;
  }

  /** Lets time flow; where nobody but a hand drives, the program takes over. */
  run(): void {
    if (this.#driver === "me") this.setDriver("program");
    this.#isStepping = false;
    this.#start();
  }

  pause(): void {
    this.#isRunning = false;
    this.#isStepping = false;
    this.#isDirty = true;
  }

  /** Takes one decision (one tick, or one whole manoeuvre) and pauses. */
  step(): void {
    this.run();
    this.#isStepping = true;
  }

  /** Robot to start; maze, program, driver and speed stay. */
  reset(): void {
    this.#remote.cancel(this.#simulation, "reset");
    this.#simulation.reset();
    this.#program = new ProgramRun(this.#simulation, this.#decider);
    this.#putAtStart();
  }

  setSpeed(speed: Speed): void {
    this.#speed = speed;
    this.#timestep.clear();
  }

  /** Hands the robot over: it stops; a script's robot is live at once, the others wait. */
  setDriver(driver: DriverName): void {
    if (driver === this.#driver) return;
    if (this.#driver === "remote") this.#remote.cancel(this.#simulation, "handedOver");
    this.#simulation.apply({ action: "stop" });
    this.#program.reconsider();
    this.#driver = driver;
    this.pause();
    if (driver === "remote") this.#start();
  }

  /** A drive key goes down or up; whoever drove before, the hand drives now. */
  hold(key: DriveKey): void {
    if (key === "stop" && this.#driver !== "me") return;
    this.setDriver("me");
    this.#simulation.apply(commandOfKey(key));
    if (key === "stop") this.pause();
    else this.#start();
  }

  /** Takes a remote command; where Remote does not drive, it ends at once and says so. */
  accept(delivery: Delivery): void {
    this.#remote.accept(delivery);
    if (this.#driver !== "remote") this.#remote.cancel(this.#simulation, "notRemote");
    this.#isDirty = true;
  }

  /** Ends what remote commands run and wait. */
  cancelRemote(reason: CancelReason): void {
    if (this.#driver !== "remote") return;
    this.#remote.cancel(this.#simulation, reason);
    this.#isDirty = true;
  }

  /** Runs the ticks that real time asks for since the last call. */
  advance(): void {
    const now = this.#now();
    const elapsed = now - this.#lastAt;
    this.#lastAt = now;
    if (!this.#isRunning) return;
    if (this.#speed === "max") {
      while (this.#isRunning && this.#now() - now < MAX_SPEED_BUDGET_MS) {
        this.#runTicks(MAX_SPEED_CHUNK);
      }
    } else {
      this.#runTicks(this.#timestep.ticksFor(elapsed, this.#speed));
    }
  }

  /** What there is to draw and to tell since the last call; null when nothing changed. */
  takeNews(): { frame: Frame; moments: Moment[] } | null {
    if (!this.#isDirty) return null;
    this.#isDirty = false;
    const moments = this.#moments;
    this.#moments = [];
    const snapshot = this.snapshot();
    const { progress } = this.#simulation;
    const bumps = this.#bumpPlaces;
    this.#bumpPlaces = [];
    const view = "now";
    const frame: Frame = {
      snapshot,
      progress,
      view,
      nowTick: snapshot.tick,
      bumps,
      ...this.#trail.take(),
    };
    return { frame, moments };
  }

  /** The newest snapshot; every call has its own seq. */
  snapshot(): Snapshot {
    const isProgram = this.#driver === "program";
    if (isProgram) this.#program.decide();
    return {
      ...this.#simulation.report(),
      seq: ++this.#seq,
      state: this.#isRunning ? "running" : "paused",
      driver: this.#driver,
      line: isProgram ? this.#program.line : null,
      command: this.#remote.running,
    };
  }

  #start(): void {
    if (!this.#isRunning) {
      this.#timestep.clear();
      this.#lastAt = this.#now();
    }
    this.#isRunning = true;
    this.#isDirty = true;
  }

  #runTicks(count: number): void {
    for (let i = 0; i < count && this.#isRunning; i++) this.#tick();
    if (count > 0) this.#isDirty = true;
  }

  #tick(): void {
    const simulation = this.#simulation;
    const { bumps, goalTick } = simulation;
    if (this.#driver === "remote") this.#remote.begin(simulation);
    if (this.#driver === "program") this.#program.step();
    else simulation.step();
    if (this.#driver === "remote") this.#remote.finish(simulation);

    const { x, y } = simulation.pose;
    this.#trail.add(x, y);
    if (simulation.bumps > bumps) this.#tell("bump");
    if (simulation.goalTick !== goalTick) {
      this.#tell("goal");
      // A script decides for itself what comes after the goal.
      if (this.#driver === "program") this.pause();
    }
    if (this.#isStepping && !simulation.isManoeuvring) this.pause();
  }

  #tell(kind: Moment["kind"]): void {
    const { tick, pose, bumps } = this.#simulation;
    if (kind === "bump") this.#bumpPlaces.push(pose.x, pose.y);
    // Many bumps in one frame are one to a watcher; the goal is told in any case.
    this.#moments = this.#moments.filter((each) => each.kind !== kind);
    this.#moments.push({
      kind,
      tick,
      pose,
      bumps,
      cause: null,
      driver: this.#driver,
      line: this.#driver === "program" ? this.#program.line : null,
    });
  }

  #putAtStart(): void {
    this.pause();
    this.#moments = [];
    this.#bumpPlaces = [];
    this.#beginTrail();
    if (this.#driver === "remote") this.#start();
  }

  #beginTrail(): void {
    const { x, y } = this.#simulation.pose;
    this.#trail.reset(x, y);
  }
}
