/**
 * One robot under its drivers, from maze, program and inputs alone: the same inputs at the same ticks
 * give the same bits. The page's live run, its past and the replay of a file are all this class, so
 * that they cannot differ.
 *
 * At the end of each tick on which the program drives and no manoeuvre runs, the decision for the next
 * tick is taken: the line that is shown is the one that the shown readings chose.
 */
import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { Command, DriverName, LineRef, Pose, RobotReport } from "@corridor/protocol";
import {
  Approach,
  ProgramRun,
  Simulation,
  SnapshotDigest,
  type ApproachState,
  type BumpCause,
  type MotionEnding,
  type Progress,
  type ProgramRunState,
  type SimulationState,
} from "@corridor/simulation";
import type { RunInput } from "./run-input.ts";
import type { TimelineDriver } from "./timeline.ts";

/** Once a simulated second, a snapshot goes into the digest. */
const DIGEST_TICKS = 60;

/** A run at the end of a tick. */
export interface RunState {
  maze: MazeDocument;
  program: ProgramDocument;
  driver: DriverName;
  command: number | null;
  line: LineRef | null;
  simulation: SimulationState;
  decisions: ProgramRunState;
  approach: ApproachState;
  digest: SnapshotDigest;
}

export class Run {
  readonly #simulation: Simulation;
  readonly #decisions: ProgramRun;
  readonly #approach = new Approach();
  #digest = new SnapshotDigest();
  #maze: MazeDocument;
  #program: ProgramDocument;
  #driver: DriverName = "program";
  /** seq of the script's command that runs; null when none does */
  #command: number | null = null;
  #commandEnding: MotionEnding | null = null;
  /** the line that decided last, as it was then */
  #line: LineRef | null = null;
  #cause: BumpCause | null = null;

  /** A robot at its start, driven by the program. */
  constructor(maze: MazeDocument, program: ProgramDocument) {
    this.#maze = maze;
    this.#program = program;
    this.#simulation = new Simulation(maze);
    this.#decisions = new ProgramRun(this.#simulation, new CompiledProgram(program));
    this.#decide();
  }

  get maze(): MazeDocument {
    return this.#maze;
  }

  get program(): ProgramDocument {
    return this.#program;
  }

  get driver(): DriverName {
    return this.#driver;
  }

  /** seq of the script's command that runs; null when none does. */
  get command(): number | null {
    return this.#command;
  }

  /** How the script's last command ended by itself; null while one runs. */
  get commandEnding(): MotionEnding | null {
    return this.#commandEnding;
  }

  /** The line that decides now or began the manoeuvre that runs; null unless the program drives. */
  get line(): LineRef | null {
    return this.#driver === "program" ? this.#decisions.line : null;
  }

  /** TimelineDriver drives the next tick. */
  get timelineDriver(): Exclude<TimelineDriver, "mixed"> {
    return this.#driver === "program" ? this.#decisions.line : this.#driver;
  }

  get tick(): number {
    return this.#simulation.tick;
  }

  get pose(): Pose {
    return this.#simulation.pose;
  }

  /** The robot's centre, in units. */
  get x(): number {
    return this.#simulation.x;
  }

  get y(): number {
    return this.#simulation.y;
  }

  /** Units driven so far, forward and backward. */
  get distance(): number {
    return this.#simulation.distance;
  }

  get bumps(): number {
    return this.#simulation.bumps;
  }

  /** Tick at which the robot first stood in a goal; null when it has not yet. */
  get goalTick(): number | null {
    return this.#simulation.goalTick;
  }

  /** Whether a block stopped the robot in the newest tick. */
  get isStopped(): boolean {
    return this.#simulation.isStopped;
  }

  /** Whether an action runs that ends by itself. */
  get isManoeuvring(): boolean {
    return this.#simulation.isManoeuvring;
  }

  /** How far the manoeuvre is; null when none runs. */
  get progress(): Progress | null {
    return this.#simulation.progress;
  }

  /** Front, right, back, left in units. */
  get readings(): Float64Array {
    return this.#simulation.readings;
  }

  /** The cell under the robot's centre, as `row * columns + column`. */
  get cell(): number {
    return this.#simulation.cell;
  }

  /**
   * Tick at whose end the last decision came: another line, a new manoeuvre, or another's command. A
   * line that is chosen again and again is one decision.
   */
  get decidedAt(): number {
    return this.#approach.decidedAt;
  }

  /** What was decided or commanded last. */
  get decision(): Command {
    return this.#approach.command;
  }

  /** How it came to the bump of the last tick; null when there was none. */
  get cause(): BumpCause | null {
    return this.#cause;
  }

  /** What the robot reports at the end of this tick. */
  report(): RobotReport {
    return this.#simulation.report();
  }

  /** Of the run up to here: 16 hexadecimal digits. */
  digest(): string {
    const digest = this.#digest.clone();
    digest.add(this.report());
    return digest.toString();
  }

  /**
   * Takes an input at the end of this tick.
   * @returns false where it cannot be: another maze leaves the robot no place, or a command comes while
   * the program drives. Then nothing has changed.
   */
  apply(input: RunInput): boolean {
    const isCommand = input.do === "command" || input.do === "cancel";
    if (isCommand && this.#driver === "program") return false;
    switch (input.do) {
      case "driver":
        this.#stop();
        this.#decisions.reconsider();
        this.#driver = input.driver;
        break;
      case "command":
        this.#startCommand(input.command, input.seq ?? null);
        break;
      case "cancel":
        this.#stop();
        break;
      case "program":
        this.#program = input.program;
        this.#decisions.reconsider(new CompiledProgram(input.program));
        break;
      case "maze":
        if (!this.#simulation.setMaze(input.maze)) return false;
        this.#maze = input.maze;
        this.#decisions.reconsider();
        break;
    }
    this.#decide();
    return true;
  }

  /** One tick. */
  step(): void {
    const simulation = this.#simulation;
    const { bumps } = simulation;
    if (this.#driver === "program") this.#decisions.step();
    else simulation.step();
    this.#cause = simulation.bumps === bumps ? null : this.#approach.cause(simulation);
    if (this.#command !== null) this.#closeCommand();
    this.#approach.update(simulation);
    if (this.#driver === "program") this.#decide();
    if (simulation.tick % DIGEST_TICKS === 0) this.#digest.add(simulation.report());
  }

  save(): RunState {
    return {
      maze: this.#maze,
      program: this.#program,
      driver: this.#driver,
      command: this.#command,
      line: this.#line,
      simulation: this.#simulation.save(),
      decisions: this.#decisions.save(),
      approach: this.#approach.save(),
      digest: this.#digest.clone(),
    };
  }

  restore(state: RunState): void {
    const isProgram = state.program === this.#program;
    this.#simulation.restore(state.simulation, state.maze);
    this.#decisions.restore(
      state.decisions,
      isProgram ? undefined : new CompiledProgram(state.program),
    );
    this.#maze = state.maze;
    this.#program = state.program;
    this.#driver = state.driver;
    this.#command = state.command;
    this.#commandEnding = null;
    this.#approach.restore(state.approach);
    this.#digest = state.digest.clone();
    this.#line = state.line;
    this.#cause = null;
  }

  #startCommand(command: Command, seq: number | null): void {
    const simulation = this.#simulation;
    simulation.apply(command);
    this.#approach.recordDecision(simulation, command);
    this.#line = null;
    this.#command = seq;
    this.#commandEnding = null;
    // Nothing to drive (stop, or a move of 0) is done at once.
    if (simulation.ending !== null || command.action === "stop") this.#finishCommand("completed");
  }

  /** Ends the script's command whose manoeuvre is over or that ran into a wall. */
  #closeCommand(): void {
    const simulation = this.#simulation;
    if (simulation.ending !== null) {
      this.#finishCommand(simulation.ending);
    } else if (!simulation.isManoeuvring && simulation.isStopped) {
      this.#finishCommand("collided");
      simulation.apply({ action: "stop" });
    }
  }

  #finishCommand(ending: MotionEnding): void {
    if (this.#command !== null) this.#commandEnding = ending;
    this.#command = null;
  }

  /** Whatever runs is over, and the robot stands. */
  #stop(): void {
    const stop: Command = { action: "stop" };
    this.#simulation.apply(stop);
    this.#approach.recordDecision(this.#simulation, stop);
    this.#line = null;
    this.#command = null;
    this.#commandEnding = null;
  }

  /** Where the program drives and nothing is decided yet: decides for the next tick. */
  #decide(): void {
    if (this.#driver !== "program") return;
    const command = this.#decisions.decide();
    if (command === null) return;
    const { line } = this.#decisions;
    const isSame = line === this.#line && command.action === this.decision.action;
    if (isSame && !this.#simulation.isManoeuvring) return;
    this.#line = line;
    this.#approach.recordDecision(this.#simulation, command);
  }
}
