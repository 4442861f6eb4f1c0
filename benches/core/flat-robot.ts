/**
 * The Classic robot without a body: rules, motion and snapshot as flat numbers, for the contenders that
 * the product is measured against. Written once more on purpose, and as lean as it gets, so that no
 * rival pays for the product's own way of doing it.
 *
 * Numbers live in one Float64Array: V8 then neither boxes nor allocates them. Units and degrees a tick.
 */
import { normaliseHeading, writeUnitVector } from "@corridor/geometry";
import { CELL, headingNames, sizeOf, type MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import { plainActions, type RobotReport } from "@corridor/protocol";

/** Places in `state`; the unit vector of the heading sits first, where `writeUnitVector` puts it. */
export const WAY_X = 0;
export const WAY_Y = 1;
export const X = 2;
export const Y = 3;
/** what this tick asks for: units along the heading, negative backward, and degrees */
export const LINEAR = 4;
const ANGULAR = 5;
const HEADING = 6;
/** what is left of the part that runs: units of a drive, degrees of a turn */
const LEFT = 7;
/** the heading at the end of the turn that runs; NaN before its first tick and outside of turns */
const TARGET = 8;
const DISTANCE = 9;
/** direction into the wall that the robot touches */
const NORMAL_X = 10;
const NORMAL_Y = 11;

export const RADIUS = 25;
const DRIVE_STEP = 100 / 60;
const TURN_STEP = 150 / 60;
const CRUMB = 1e-9;
const TOUCHING = 1e-6;
/** Two contacts with normals closer than this (cosine) are one and the same wall. */
const SAME_WALL = 0.99;

const NO_PART = 0;
const DRIVE = 1;
const TURN = 2;
const PARTS = 3;
const STOP = plainActions.indexOf("stop");

type Part = readonly [kind: number, amount: number];
const partsOf = {
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
} as const satisfies Record<(typeof plainActions)[number], readonly Part[]>;

/** Parts of every action in the order of `plainActions`, three places each. */
const kinds = new Uint8Array(plainActions.length * PARTS);
const amounts = new Float64Array(plainActions.length * PARTS);
for (const [action, name] of plainActions.entries()) {
  for (const [part, [kind, amount]] of partsOf[name].entries()) {
    kinds[action * PARTS + part] = kind;
    amounts[action * PARTS + part] = amount;
  }
}

export class FlatRobot {
  readonly state = new Float64Array(12);
  /** front, right, back, left in units */
  readonly readings = new Float64Array(4);
  readonly #rules: CompiledProgram;
  /** index in `plainActions` by rule + 1; the default's at 0 */
  readonly #actions: Uint8Array;
  readonly #goals: Uint8Array;
  readonly #columns: number;
  #action = STOP;
  /** place of the part that runs in `kinds` and `amounts`, and the place after the action's last */
  #part = 0;
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

  /** The cell under the robot's centre, as `row * columns + column`. */
  get cell(): number {
    const { state } = this;
    return Math.imul(((state[Y] ?? 0) / CELL) | 0, this.#columns) + (((state[X] ?? 0) / CELL) | 0);
  }

  /** Units driven so far. */
  get distance(): number {
    return this.state[DISTANCE] ?? 0;
  }

  /** Lets the rules decide unless a manoeuvre runs, then sets `state[LINEAR]` and the turn of this tick. */
  plan(): void {
    if (!this.#isManoeuvre)
      this.#begin(this.#actions[this.#rules.decide(this.readings) + 1] ?? STOP);
    const { state } = this;
    const part = this.#part;
    state[LINEAR] = 0;
    state[ANGULAR] = 0;
    if (part === this.#end) return;
    const amount = amounts[part] ?? 0;
    const left = state[LEFT] ?? 0;
    if (kinds[part] === DRIVE) {
      const step = Math.min(DRIVE_STEP, left);
      state[LINEAR] = amount < 0 ? -step : step;
    } else {
      if (left === Math.abs(amount))
        state[TARGET] = normaliseHeading((state[HEADING] ?? 0) + amount);
      const step = Math.min(TURN_STEP, left);
      state[ANGULAR] = amount < 0 ? -step : step;
    }
  }

  /** The body drove `distance` units and ran into nothing. */
  drove(distance: number): void {
    this.#inContact = false;
    this.state[DISTANCE] = (this.state[DISTANCE] ?? 0) + distance;
  }

  /** The body drove `distance` units and was stopped by a wall in the direction (normalX, normalY). */
  ranInto(distance: number, normalX: number, normalY: number): void {
    const { state } = this;
    state[DISTANCE] = (state[DISTANCE] ?? 0) + distance;
    const cosine = (state[NORMAL_X] ?? 0) * normalX + (state[NORMAL_Y] ?? 0) * normalY;
    if (!this.#inContact || cosine <= SAME_WALL) this.#bumps++;
    this.#inContact = true;
    state[NORMAL_X] = normalX;
    state[NORMAL_Y] = normalY;
  }

  /** Turns, counts down the part that runs and goes on to the next. `isStopped`: a block stopped the robot. */
  finish(isStopped: boolean): void {
    const { state } = this;
    const linear = Math.abs(state[LINEAR] ?? 0);
    const angular = state[ANGULAR] ?? 0;
    this.#tick = (this.#tick + 1) | 0;
    if (this.#part === this.#end) return;
    const left = (state[LEFT] ?? 0) - linear - Math.abs(angular);
    state[LEFT] = left;
    const isOver = left <= CRUMB || (isStopped && this.#isManoeuvre);
    if (angular !== 0) {
      state[HEADING] = isOver
        ? (state[TARGET] ?? 0)
        : normaliseHeading((state[HEADING] ?? 0) + angular);
      writeUnitVector(state[HEADING], state);
    }
    if (isOver) this.#next();
  }

  /** Notes the first tick with the whole robot in a goal cell. */
  lookForGoal(): void {
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

  #begin(action: number): void {
    // forward, reverse and stop come first, and are the same however often they are chosen.
    if (action === this.#action && action <= STOP) return;
    const first = Math.imul(action, PARTS);
    let end = first;
    while (end < first + PARTS && kinds[end] !== NO_PART) end++;
    this.#action = action;
    this.#part = first;
    this.#end = end;
    this.#isManoeuvre = action > STOP;
    this.state[LEFT] = Math.abs(amounts[first] ?? 0);
  }

  #next(): void {
    this.#part++;
    if (this.#part < this.#end) {
      this.state[LEFT] = Math.abs(amounts[this.#part] ?? 0);
      return;
    }
    this.#isManoeuvre = false;
    this.#action = STOP;
  }
}

function isWithinCell(coordinate: number): boolean {
  const fromMiddle = (coordinate % CELL) - CELL / 2;
  return Math.abs(fromMiddle) <= CELL / 2 - RADIUS + TOUCHING;
}
