/**
 * The Classic robot without collisions and sensors: rules, motion and snapshots, for the variants
 * that the product is compared with. It duplicates the product's logic in the fastest form, so that
 * no variant includes the product's overhead.
 *
 * All numbers are in one Float64Array, so that V8 neither boxes nor allocates them. Speeds are in
 * units and degrees per tick.
 */
import { normaliseHeading, writeUnitVector } from "@corridor/geometry";
import { CELL, headingNames, sizeOf, type MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import { plainActions, type RobotReport } from "@corridor/protocol";

/**
 * Indices in `state`. The unit vector of the heading is first, because `writeUnitVector` writes
 * there.
 */
export const DIRECTION_X = 0;
export const DIRECTION_Y = 1;
export const X = 2;
export const Y = 3;
/** Motion of this tick: units along the heading (negative: backward), and degrees clockwise. */
export const LINEAR = 4;
const ANGULAR = 5;
const HEADING = 6;
/** Remainder of the current phase: units of a drive, or degrees of a turn. */
const REMAINING = 7;
/** Heading at the end of the current turn, in degrees. */
const TARGET = 8;
const DISTANCE = 9;
/** Unit vector that points into the wall that the robot touches. */
const NORMAL_X = 10;
const NORMAL_Y = 11;

export const RADIUS = 25;
const DRIVE_STEP = 100 / 60;
const TURN_STEP = 150 / 60;
/** Tolerance for rounding errors at the end of a phase. */
const EPSILON = 1e-9;
/** Tolerance in units for the robot to be inside a goal cell. */
const GOAL_TOLERANCE = 1e-6;
/** Two contacts are with the same wall if the cosine between their normals is larger. */
const SAME_WALL = 0.99;

const NO_PHASE = 0;
const DRIVE = 1;
const TURN = 2;
const MAX_PHASES = 3;
const STOP = plainActions.indexOf("stop");

type Phase = readonly [kind: number, amount: number];
const phasesOf = {
  forward: [[DRIVE, Infinity]],
  reverse: [[DRIVE, -Infinity]],
  stop: [],
  "left 90": [[TURN, -90]],
  "right 90": [[TURN, 90]],
  "turn 180": [[TURN, 180]],
  "delayed left 90": [
    [DRIVE, 50],
    [TURN, -90],
    [DRIVE, 60],
  ],
  "delayed right 90": [
    [DRIVE, 50],
    [TURN, 90],
    [DRIVE, 60],
  ],
} as const satisfies Record<(typeof plainActions)[number], readonly Phase[]>;

/** Phases of every action in the order of `plainActions`, with `MAX_PHASES` elements per action. */
const kinds = new Uint8Array(plainActions.length * MAX_PHASES);
const amounts = new Float64Array(plainActions.length * MAX_PHASES);
for (const [action, name] of plainActions.entries()) {
  for (const [phase, [kind, amount]] of phasesOf[name].entries()) {
    kinds[action * MAX_PHASES + phase] = kind;
    amounts[action * MAX_PHASES + phase] = amount;
  }
}

export class FlatRobot {
  readonly state = new Float64Array(12);
  /** Distances in units: front, right, back, left. */
  readonly readings = new Float64Array(4);
  readonly #rules: CompiledProgram;
  /** Index in `plainActions` by rule + 1; index 0 is the default. */
  readonly #actions: Uint8Array;
  readonly #goals: Uint8Array;
  readonly #columns: number;
  #action = STOP;
  /**
   * Index of the current phase in `kinds` and `amounts`, and the index after the action's last
   * phase.
   */
  #phase = 0;
  #end = 0;
  #isManoeuvre = false;
  #tick = 0;
  #goalTick = -1;
  #bumps = 0;
  #inContact = false;

  constructor(maze: MazeDocument, program: ProgramDocument) {
    const { columns, rows } = sizeOf(maze);
    this.#rules = new CompiledProgram(program);
    this.#actions = Uint8Array.of(
      plainActions.indexOf(program.default),
      ...program.rules.map((rule) => plainActions.indexOf(rule.do)),
    );
    this.#columns = columns;
    this.#goals = new Uint8Array(columns * rows);
    for (const { column, row } of maze.goals) this.#goals[row * columns + column] = 1;
    const { state } = this;
    state[X] = maze.start.column * CELL + CELL / 2;
    state[Y] = maze.start.row * CELL + CELL / 2;
    state[HEADING] = headingNames.indexOf(maze.start.heading) * 90;
    writeUnitVector(state[HEADING], state);
  }

  /** Index of the cell under the robot's centre: `row * columns + column`. */
  get cell(): number {
    const { state } = this;
    return Math.imul(((state[Y] ?? 0) / CELL) | 0, this.#columns) + (((state[X] ?? 0) / CELL) | 0);
  }

  /** Driven distance in units. */
  get distance(): number {
    return this.state[DISTANCE] ?? 0;
  }

  /**
   * Evaluates the rules unless a manoeuvre is running, then sets the motion of this tick in
   * `state`.
   */
  plan(): void {
    if (!this.#isManoeuvre)
      this.#start(this.#actions[this.#rules.decide(this.readings) + 1] ?? STOP);
    const { state } = this;
    const phase = this.#phase;
    state[LINEAR] = 0;
    state[ANGULAR] = 0;
    if (phase === this.#end) return;
    const amount = amounts[phase] ?? 0;
    const remaining = state[REMAINING] ?? 0;
    if (kinds[phase] === DRIVE) {
      const step = Math.min(DRIVE_STEP, remaining);
      state[LINEAR] = amount < 0 ? -step : step;
    } else {
      if (remaining === Math.abs(amount))
        state[TARGET] = normaliseHeading((state[HEADING] ?? 0) + amount);
      const step = Math.min(TURN_STEP, remaining);
      state[ANGULAR] = amount < 0 ? -step : step;
    }
  }

  /** Records that the body drove `distance` units without a collision. */
  moveFreely(distance: number): void {
    this.#inContact = false;
    this.state[DISTANCE] = (this.state[DISTANCE] ?? 0) + distance;
  }

  /** Records that the body drove `distance` units, until a wall in direction (normalX, normalY). */
  collide(distance: number, normalX: number, normalY: number): void {
    const { state } = this;
    state[DISTANCE] = (state[DISTANCE] ?? 0) + distance;
    const cosine = (state[NORMAL_X] ?? 0) * normalX + (state[NORMAL_Y] ?? 0) * normalY;
    if (!this.#inContact || cosine <= SAME_WALL) this.#bumps++;
    this.#inContact = true;
    state[NORMAL_X] = normalX;
    state[NORMAL_Y] = normalY;
  }

  /**
   * Applies the turn of this tick and advances the current phase.
   * @param isStopped whether a block stopped the robot in this tick
   */
  finish(isStopped: boolean): void {
    const { state } = this;
    const linear = Math.abs(state[LINEAR] ?? 0);
    const angular = state[ANGULAR] ?? 0;
    this.#tick = (this.#tick + 1) | 0;
    if (this.#phase === this.#end) return;
    const remaining = (state[REMAINING] ?? 0) - linear - Math.abs(angular);
    state[REMAINING] = remaining;
    const isOver = remaining <= EPSILON || (isStopped && this.#isManoeuvre);
    if (angular !== 0) {
      state[HEADING] = isOver
        ? (state[TARGET] ?? 0)
        : normaliseHeading((state[HEADING] ?? 0) + angular);
      writeUnitVector(state[HEADING], state);
    }
    if (isOver) this.#nextPhase();
  }

  /** Records the first tick in which the robot is completely inside a goal cell. */
  checkGoal(): void {
    if (this.#goalTick >= 0 || this.#goals[this.cell] === 0) return;
    const { state } = this;
    if (isWithinCell(state[X] ?? 0) && isWithinCell(state[Y] ?? 0)) this.#goalTick = this.#tick;
  }

  report(): RobotReport {
    const { state, readings } = this;
    return {
      tick: this.#tick,
      sensors: {
        front: readings[0] ?? 0,
        right: readings[1] ?? 0,
        back: readings[2] ?? 0,
        left: readings[3] ?? 0,
      },
      pose: { x: state[X] ?? 0, y: state[Y] ?? 0, heading: state[HEADING] ?? 0 },
      motion: plainActions[this.#action] ?? "stop",
      bumps: this.#bumps,
      bumping: this.#inContact,
      goalReached: this.#goalTick >= 0,
    };
  }

  #start(action: number): void {
    // forward, reverse and stop are first in `plainActions`. Starting them again changes nothing.
    if (action === this.#action && action <= STOP) return;
    const first = Math.imul(action, MAX_PHASES);
    let end = first;
    while (end < first + MAX_PHASES && kinds[end] !== NO_PHASE) end++;
    this.#action = action;
    this.#phase = first;
    this.#end = end;
    this.#isManoeuvre = action > STOP;
    this.state[REMAINING] = Math.abs(amounts[first] ?? 0);
  }

  #nextPhase(): void {
    this.#phase++;
    if (this.#phase < this.#end) {
      this.state[REMAINING] = Math.abs(amounts[this.#phase] ?? 0);
      return;
    }
    this.#isManoeuvre = false;
    this.#action = STOP;
  }
}

function isWithinCell(coordinate: number): boolean {
  const fromMiddle = (coordinate % CELL) - CELL / 2;
  return Math.abs(fromMiddle) <= CELL / 2 - RADIUS + GOAL_TOLERANCE;
}
