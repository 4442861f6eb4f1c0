/**
 * Moves the robot's body among blocks and detects contacts with matter-js. No other module decides
 * whether the robot can move. This is the only file that imports matter-js.
 *
 * - Only the blocks of the 3 x 3 cells around the robot are bodies, from a pool of nine. The robot
 *   moves at most 30 units in a tick, so the other blocks cannot matter, and the cost of a tick
 *   does not depend on the size of the maze.
 * - The body never rotates in matter-js, because a disc has no orientation. The simulation stores
 *   the heading. matter-js then uses only + - * / and sqrt, which return the same bits everywhere.
 * - A contact stops the robot at the wall. A solver that separates bodies would slide the robot
 *   along the wall, so this class resolves a contact by moving the robot back along its path.
 */
import { CELL, type Grid } from "@corridor/maze";
import { writeUnitVector } from "@corridor/geometry";
import type Matter from "matter-js";
import Body from "matter-js/src/body/Body.js";
import Collision from "matter-js/src/collision/Collision.js";
import Bounds from "matter-js/src/geometry/Bounds.js";
import { ROBOT_RADIUS, TICK_SECONDS } from "../settings.ts";

/** The body and its contact at the end of a tick. */
export interface PhysicsState {
  x: number;
  y: number;
  /** corners of the body, x and y alternating; each corner has its own rounding error */
  corners: Float64Array;
  velocityX: number;
  velocityY: number;
  inContact: boolean;
  normalX: number;
  normalY: number;
  bumps: number;
}

/**
 * matter-js supports polygons only. A polygon with 64 sides around the disc, with a side towards
 * each of the four directions, is exact at the face of a block and at most 0.03 units early at its
 * corner. Its sides are up to 3 degrees from the tangent of the disc there, so a robot that grazes
 * a corner is compared with the disc.
 */
const SIDES = 64;
const TICK_MS = TICK_SECONDS * 1000;

/** Below this cosine between the direction and the normal, the robot drives along the wall. */
const GRAZING_COSINE = 1e-9;
/** A disc that is less deep in a corner, in units, only touches it. */
const TOUCHING = 1e-5;
/** Above this cosine between their normals, two contacts belong to the same wall. */
const SAME_WALL_COSINE = 0.99;
/** The robot touches at most two blocks. A third retreat corrects rounding errors. */
const MAX_RETREATS = 3;

export class PhysicsWorld {
  readonly #robot = Body.create({
    vertices: discVertices(),
    frictionAir: 0,
    inertia: Number.POSITIVE_INFINITY,
  });
  readonly #pool = Array.from({ length: 9 }, createBlock);
  /** the blocks of the 3 x 3 cells around the robot */
  readonly #near: Matter.Body[] = [];
  readonly #velocity = { x: 0, y: 0 };
  /** the state before the first placement */
  readonly #initial: PhysicsState;
  #grid: Grid;
  #cell = -1;
  #inContact = false;
  /** direction towards the touched wall */
  #normalX = 0;
  #normalY = 0;
  /** direction towards the wall of the contact that is being resolved */
  #wallX = 0;
  #wallY = 0;
  /** number of contacts since the robot was placed */
  bumps = 0;

  constructor(grid: Grid, x: number, y: number) {
    this.#grid = grid;
    this.#initial = this.save();
    this.place(x, y);
  }

  get x(): number {
    return this.#robot.position.x;
  }

  get y(): number {
    return this.#robot.position.y;
  }

  /** Whether the robot touches the wall that stopped it. */
  get inContact(): boolean {
    return this.#inContact;
  }

  /** Places the robot at a free position with an initial state, without earlier rounding errors. */
  place(x: number, y: number): void {
    this.#applyState(this.#initial);
    this.#setPosition(x, y);
    this.#gatherBlocks();
  }

  /** Returns the current state of the body and its contact. */
  save(): PhysicsState {
    const { position, vertices, velocity } = this.#robot;
    const corners = new Float64Array(2 * vertices.length);
    for (const [index, { x, y }] of vertices.entries()) {
      corners[2 * index] = x;
      corners[2 * index + 1] = y;
    }
    return {
      x: position.x,
      y: position.y,
      corners,
      velocityX: velocity.x,
      velocityY: velocity.y,
      inContact: this.#inContact,
      normalX: this.#normalX,
      normalY: this.#normalY,
      bumps: this.bumps,
    };
  }

  /** Restores a saved state. `grid` must be the grid at the time of `save`. */
  restore(state: PhysicsState, grid: Grid): void {
    this.#grid = grid;
    this.#applyState(state);
    this.#gatherBlocks();
  }

  /**
   * Replaces the grid. The robot keeps its position.
   * @returns false, without any change, if a block would overlap the robot
   */
  setGrid(grid: Grid): boolean {
    const before = this.#grid;
    this.#grid = grid;
    this.#gatherBlocks();
    const { x, y } = this.#robot.position;
    const isInside = x > 0 && y > 0 && x < grid.columns * CELL && y < grid.rows * CELL;
    // A robot that touches a wall may overlap it by a rounding error.
    if (isInside && contactsOf(this.#robot, this.#near).every(({ depth }) => depth < 1e-6)) {
      return true;
    }
    this.#grid = before;
    this.#gatherBlocks();
    return false;
  }

  /**
   * Moves the robot by (dx, dy) units, not both 0, or until it touches a block.
   * @returns whether a block stopped it
   */
  move(dx: number, dy: number): boolean {
    // If the squared distance underflows to 0, the step has no direction. Contacts do not change.
    if (dx * dx + dy * dy === 0) return false;
    const robot = this.#robot;
    const fromX = robot.position.x;
    const fromY = robot.position.y;
    this.#velocity.x = dx;
    this.#velocity.y = dy;
    Body.setVelocity(robot, this.#velocity);
    // The types require two more numbers, which matter-js 0.20 ignores.
    Body.update(robot, TICK_MS, 1, 1);
    const touched = contactsOf(robot, this.#near);
    const isStopped = touched.length > 0 && this.#retreat(touched, fromX, fromY, dx, dy);
    if (!isStopped) this.#inContact = false;
    const { x, y } = robot.position;
    const cell = ((y / CELL) | 0) * this.#grid.stride + ((x / CELL) | 0);
    if (cell !== this.#cell) this.#gatherBlocks();
    return isStopped;
  }

  /** Moves the robot back along its path until it touches the blocks without overlap. */
  #retreat(
    touched: Matter.Collision[],
    fromX: number,
    fromY: number,
    dx: number,
    dy: number,
  ): boolean {
    const step = Math.sqrt(dx * dx + dy * dy);
    const directionX = dx / step;
    const directionY = dy / step;
    let remaining = step;
    let contacts = touched;
    let isStopped = false;
    for (let attempt = 0; attempt < MAX_RETREATS && contacts.length > 0; attempt++) {
      const back = this.#retreatDistance(contacts, directionX, directionY);
      if (back === 0) break;
      if (!isStopped) this.#countContact();
      isStopped = true;
      remaining -= back;
      if (remaining <= 0) {
        this.#setPosition(fromX, fromY);
        return true;
      }
      this.#setPosition(this.x - directionX * back, this.y - directionY * back);
      contacts = contactsOf(this.#robot, this.#near);
    }
    return isStopped;
  }

  /**
   * Distance back along the direction at which all opposing contacts end, in units.
   * Stores the normal of the deepest contact.
   */
  #retreatDistance(contacts: Matter.Collision[], directionX: number, directionY: number): number {
    let back = 0;
    for (const { bodyA, bodyB, normal, depth } of contacts) {
      const block = bodyA === this.#robot ? bodyB : bodyA;
      const towards =
        normal.x * (block.position.x - this.x) + normal.y * (block.position.y - this.y) < 0
          ? -1
          : 1;
      const into = towards * (normal.x * directionX + normal.y * directionY);
      const distance =
        into < GRAZING_COSINE
          ? this.#cornerRetreat(block.position, directionX, directionY)
          : depth / into;
      if (distance <= back) continue;
      back = distance;
      this.#wallX = towards * normal.x;
      this.#wallY = towards * normal.y;
    }
    return back;
  }

  /**
   * Distance back along the direction to the place where the disc touched the corner of a block, in
   * units; 0 if the disc is not in a corner.
   */
  #cornerRetreat(block: Matter.Vector, directionX: number, directionY: number): number {
    const half = CELL / 2;
    const x = this.x - Math.max(block.x - half, Math.min(this.x, block.x + half));
    const y = this.y - Math.max(block.y - half, Math.min(this.y, block.y + half));
    // The polygon is exact at a side.
    if (x === 0 || y === 0) return 0;
    const inside = ROBOT_RADIUS * ROBOT_RADIUS - x * x - y * y;
    if (inside < 2 * ROBOT_RADIUS * TOUCHING) return 0;
    const along = x * directionX + y * directionY;
    return along + Math.sqrt(along * along + inside);
  }

  /** Counts one bump per contact, no matter how long the robot pushes against the same wall. */
  #countContact(): void {
    const isSameWall =
      this.#inContact &&
      this.#normalX * this.#wallX + this.#normalY * this.#wallY > SAME_WALL_COSINE;
    if (!isSameWall) this.bumps++;
    this.#inContact = true;
    this.#normalX = this.#wallX;
    this.#normalY = this.#wallY;
  }

  #applyState(state: PhysicsState): void {
    const robot = this.#robot;
    robot.position.x = state.x;
    robot.position.y = state.y;
    for (const [index, corner] of robot.vertices.entries()) {
      corner.x = state.corners[2 * index] ?? 0;
      corner.y = state.corners[2 * index + 1] ?? 0;
    }
    robot.velocity.x = state.velocityX;
    robot.velocity.y = state.velocityY;
    // `move` sets the previous position, and all ticks have the same length, so neither is
    // restored.
    Bounds.update(robot.bounds, robot.vertices, robot.velocity);
    this.#inContact = state.inContact;
    this.#normalX = state.normalX;
    this.#normalY = state.normalY;
    this.bumps = state.bumps;
  }

  #setPosition(x: number, y: number): void {
    this.#velocity.x = x;
    this.#velocity.y = y;
    Body.setPosition(this.#robot, this.#velocity);
  }

  /** Moves pooled bodies to the blocks around the robot's cell. */
  #gatherBlocks(): void {
    const { stride, solid } = this.#grid;
    const column = (this.x / CELL) | 0;
    const row = (this.y / CELL) | 0;
    this.#cell = row * stride + column;
    this.#near.length = 0;
    for (let r = row - 1; r <= row + 1; r++) {
      for (let c = column - 1; c <= column + 1; c++) {
        if (solid[(r + 1) * stride + c + 1] === 0) continue;
        const block = this.#pool[this.#near.length];
        if (block === undefined) throw new Error("more than nine blocks around the robot");
        this.#velocity.x = c * CELL + CELL / 2;
        this.#velocity.y = r * CELL + CELL / 2;
        Body.setPosition(block, this.#velocity);
        this.#near.push(block);
      }
    }
  }
}

/**
 * Contacts of a body, in the order of `others`. Like matter-js's Query, but for bodies without
 * parts.
 */
function contactsOf(body: Matter.Body, others: readonly Matter.Body[]): Matter.Collision[] {
  const contacts: Matter.Collision[] = [];
  for (const other of others) {
    if (!Bounds.overlaps(other.bounds, body.bounds)) continue;
    const contact = Collision.collides(other, body);
    if (contact !== null) contacts.push(contact);
  }
  return contacts;
}

function createBlock(): Matter.Body {
  const half = CELL / 2;
  return Body.create({
    isStatic: true,
    vertices: [
      { x: -half, y: -half },
      { x: half, y: -half },
      { x: half, y: half },
      { x: -half, y: half },
    ],
  });
}

/**
 * Corners of the polygon whose sides touch the disc. Uses the project's deterministic sine and
 * cosine.
 */
function discVertices(): { x: number; y: number }[] {
  const vector = new Float64Array(2);
  writeUnitVector(180 / SIDES, vector);
  const cornerRadius = ROBOT_RADIUS / Math.abs(vector[1] ?? 1);
  return Array.from({ length: SIDES }, (_, side) => {
    writeUnitVector(((side + 0.5) * 360) / SIDES, vector);
    return { x: (vector[0] ?? 0) * cornerRadius, y: (vector[1] ?? 0) * cornerRadius };
  });
}
