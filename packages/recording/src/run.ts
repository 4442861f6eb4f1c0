/**
 * One robot and its drivers. Maze, program and inputs determine the run: the same inputs at the
 * same ticks result in the same bits. The page uses this class for the live run, its past and the
 * replay of a file, so that they cannot differ.
 *
 * If the program drives and no manoeuvre runs, it decides for the next tick at the end of each
 * tick. The displayed line therefore always matches the displayed readings.
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

/** Interval of the snapshots in the digest, in ticks: one simulated second. */
const DIGEST_TICKS = 60;

/** State of a run at the end of a tick. */
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
  /** seq of the script's running command, or null */
  #command: number | null = null;
  #commandEnding: MotionEnding | null = null;
  /** line of the last decision */
  #line: LineRef | null = null;
  /** line that drove the last tick */
  #drivenBy: LineRef | null = null;
  #cause: BumpCause | null = null;

  /** Creates a run with the robot at its start, driven by the program. */
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

  /** seq of the script's running command, or null. */
  get command(): number | null {
    return this.#command;
  }

  /** Ending of the script's last command that ended by itself; null while one runs. */
  get commandEnding(): MotionEnding | null {
    return this.#commandEnding;
  }

  /**
   * The line that decides now or that started the running manoeuvre; null unless the program
   * drives.
   */
  get line(): LineRef | null {
    return this.#driver === "program" ? this.#decisions.line : null;
  }

  /**
   * The line that drove the last tick. Null if another driver did, at the start, and after an input
   * at this tick.
   */
  get drivenBy(): LineRef | null {
    return this.#drivenBy;
  }

  /** Driver of the next tick, or its program line. */
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

  /** Distance driven so far, forward and backward, in units. */
  get distance(): number {
    return this.#simulation.distance;
  }

  get bumps(): number {
    return this.#simulation.bumps;
  }

  /** First tick at whose end the robot was in a goal; null before. */
  get goalTick(): number | null {
    return this.#simulation.goalTick;
  }

  /** Whether the whole robot is inside a goal cell now. */
  get isInGoal(): boolean {
    return this.#simulation.isInGoal;
  }

  /** Whether a block stopped the robot in the last tick. */
  get isStopped(): boolean {
    return this.#simulation.isStopped;
  }

  /** Whether a running action ends by itself. */
  get isManoeuvring(): boolean {
    return this.#simulation.isManoeuvring;
  }

  /** Progress of the running manoeuvre, or null. */
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
   * Tick at whose end the last decision was made: another line, a new manoeuvre, or a command of
   * another driver. Repeated choices of one line count as one decision.
   */
  get decidedAt(): number {
    return this.#approach.decidedAt;
  }

  /** The last decision or command. */
  get decision(): Command {
    return this.#approach.command;
  }

  /** Cause of a bump in the last tick, or null. */
  get cause(): BumpCause | null {
    return this.#cause;
  }

  /** Returns the robot's report at the end of this tick. */
  report(): RobotReport {
    return this.#simulation.report();
  }

  /** Returns the digest of the run up to this tick: 16 hexadecimal digits. */
  digest(): string {
    const digest = this.#digest.clone();
    digest.add(this.report());
    return digest.toString();
  }

  /**
   * Applies an input at the end of this tick.
   * @returns false, without any change, if the robot would overlap a block of a new maze, or for a
   *   command while the program drives
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
    this.#drivenBy = null;
    this.#decide();
    return true;
  }

  /** Runs one tick. */
  step(): void {
    const simulation = this.#simulation;
    const { bumps } = simulation;
    this.#drivenBy = this.line;
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
    this.#drivenBy = null;
    this.#cause = null;
  }

  #startCommand(command: Command, seq: number | null): void {
    const simulation = this.#simulation;
    simulation.apply(command);
    this.#approach.recordDecision(simulation, command);
    this.#line = null;
    this.#command = seq;
    this.#commandEnding = null;
    // A command without motion (stop, or a move of 0) ends immediately.
    if (simulation.ending !== null || command.action === "stop") this.#finishCommand("completed");
  }

  /** Ends the script's command after its manoeuvre or a collision. */
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

  /** Cancels the current motion or command and stops the robot. */
  #stop(): void {
    const stop: Command = { action: "stop" };
    this.#simulation.apply(stop);
    this.#approach.recordDecision(this.#simulation, stop);
    this.#line = null;
    this.#command = null;
    this.#commandEnding = null;
  }

  /** Decides for the next tick if the program drives and no decision exists. */
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
