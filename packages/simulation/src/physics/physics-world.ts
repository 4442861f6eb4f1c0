/**
 * The robot's body among blocks, in matter-js: it moves the body and finds the contacts, and nothing
 * beside it decides whether the robot may move. The only file that imports matter-js.
 *
 * - Only the blocks of the 3 x 3 cells around the robot are bodies; nine of them wait in a pool. The
 *   robot reaches at most 30 units in a tick, so this world is the world of all blocks, and the cost
 *   of a tick does not grow with the maze.
 * - The body never turns in matter-js (a disc looks the same from all sides); the heading lives in
 *   the simulation. matter-js then uses only + - * / and sqrt, and gives the same bits everywhere.
 * - Contact stops the robot where it touches. A solver that pushes bodies apart would slide it along
 *   the wall, so the way out of a contact is back along the way the robot came.
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
  /** corners of the body, x and y by turns: each carries its own crumbs of rounding */
  corners: Float64Array;
  velocityX: number;
  velocityY: number;
  inContact: boolean;
  normalX: number;
  normalY: number;
  bumps: number;
}

/**
 * matter-js knows polygons only. One with 64 sides around the disc, a flat side to each of the four
 * directions: exact against the face of a block, at most 0.03 units early at a block's corner.
 */
const SIDES = 64;
const TICK_MS = TICK_SECONDS * 1000;

/** Below this part of the way leading into a block, the robot drives along it and does not touch. */
const GRAZING = 1e-9;
/** Two contacts with normals closer than this (cosine) are one and the same wall. */
const SAME_WALL = 0.99;
/** Retreats from blocks in turn; two blocks meet the robot at most, a third look settles rounding. */
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
  /** the body before it is put anywhere */
  readonly #fresh: PhysicsState;
  #grid: Grid;
  #cell = -1;
  #inContact = false;
  /** direction into the wall that the robot touches */
  #normalX = 0;
  #normalY = 0;
  /** the same of the contact that is being looked at */
  #wallX = 0;
  #wallY = 0;
  /** contacts since the robot was placed */
  bumps = 0;

  constructor(grid: Grid, x: number, y: number) {
    this.#grid = grid;
    this.#fresh = this.save();
    this.place(x, y);
  }

  get x(): number {
    return this.#robot.position.x;
  }

  get y(): number {
    return this.#robot.position.y;
  }

  /** Whether the robot still touches the wall that stopped it. */
  get inContact(): boolean {
    return this.#inContact;
  }

  /** Puts the robot at a free place and forgets all that it met: no crumb of an earlier way stays. */
  place(x: number, y: number): void {
    this.#takeOver(this.#fresh);
    this.#putAt(x, y);
    this.#gatherBlocks();
  }

  /** The body and its contact as they are. */
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

  /** Puts body and contact back as they were saved, in the grid that they were saved in. */
  restore(state: PhysicsState, grid: Grid): void {
    this.#grid = grid;
    this.#takeOver(state);
    this.#gatherBlocks();
  }

  /**
   * Another maze around the robot, which stays where it is.
   * @returns false when a block would stand in the robot: then nothing has changed
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
   * Moves the robot by (dx, dy) units, not both 0, or as far as it can before it touches a block.
   * @returns whether a block stopped it
   */
  move(dx: number, dy: number): boolean {
    // A way too short to be squared has no direction, and is none: what the robot touches it still touches.
    if (dx * dx + dy * dy === 0) return false;
    const robot = this.#robot;
    const fromX = robot.position.x;
    const fromY = robot.position.y;
    this.#velocity.x = dx;
    this.#velocity.y = dy;
    Body.setVelocity(robot, this.#velocity);
    // The types ask for two more numbers that matter-js 0.20 no longer reads.
    Body.update(robot, TICK_MS, 1, 1);
    const touched = contactsOf(robot, this.#near);
    const isStopped = touched.length > 0 && this.#retreat(touched, fromX, fromY, dx, dy);
    if (!isStopped) this.#inContact = false;
    const { x, y } = robot.position;
    const cell = ((y / CELL) | 0) * this.#grid.stride + ((x / CELL) | 0);
    if (cell !== this.#cell) this.#gatherBlocks();
    return isStopped;
  }

  /** Takes the robot back along its way until it only touches what it ran into. */
  #retreat(
    touched: Matter.Collision[],
    fromX: number,
    fromY: number,
    dx: number,
    dy: number,
  ): boolean {
    const step = Math.sqrt(dx * dx + dy * dy);
    const wayX = dx / step;
    const wayY = dy / step;
    let left = step;
    let contacts = touched;
    let isStopped = false;
    for (let turn = 0; turn < MAX_RETREATS && contacts.length > 0; turn++) {
      const back = this.#wayOut(contacts, wayX, wayY);
      if (back === 0) break;
      if (!isStopped) this.#countContact();
      isStopped = true;
      left -= back;
      if (left <= 0) {
        this.#putAt(fromX, fromY);
        return true;
      }
      this.#putAt(this.x - wayX * back, this.y - wayY * back);
      contacts = contactsOf(this.#robot, this.#near);
    }
    return isStopped;
  }

  /** How far back along the way (wayX, wayY) all contacts that oppose it are left; keeps the worst one's normal. */
  #wayOut(contacts: Matter.Collision[], wayX: number, wayY: number): number {
    let back = 0;
    for (const { bodyA, bodyB, normal, depth } of contacts) {
      const block = bodyA === this.#robot ? bodyB : bodyA;
      const towards =
        normal.x * (block.position.x - this.x) + normal.y * (block.position.y - this.y) < 0
          ? -1
          : 1;
      const into = towards * (normal.x * wayX + normal.y * wayY);
      if (into < GRAZING || depth / into <= back) continue;
      back = depth / into;
      this.#wallX = towards * normal.x;
      this.#wallY = towards * normal.y;
    }
    return back;
  }

  /** One bump for each contact, however long the robot keeps pushing at the same wall. */
  #countContact(): void {
    const isSameWall =
      this.#inContact && this.#normalX * this.#wallX + this.#normalY * this.#wallY > SAME_WALL;
    if (!isSameWall) this.bumps++;
    this.#inContact = true;
    this.#normalX = this.#wallX;
    this.#normalY = this.#wallY;
  }

  #takeOver(state: PhysicsState): void {
    const robot = this.#robot;
    robot.position.x = state.x;
    robot.position.y = state.y;
    for (const [index, corner] of robot.vertices.entries()) {
      corner.x = state.corners[2 * index] ?? 0;
      corner.y = state.corners[2 * index + 1] ?? 0;
    }
    robot.velocity.x = state.velocityX;
    robot.velocity.y = state.velocityY;
    // The previous position is written anew before each move, and every tick has the same length.
    Bounds.update(robot.bounds, robot.vertices, robot.velocity);
    this.#inContact = state.inContact;
    this.#normalX = state.normalX;
    this.#normalY = state.normalY;
    this.bumps = state.bumps;
  }

  #putAt(x: number, y: number): void {
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
        if (block === undefined) throw new Error("nine blocks fill the cells around the robot");
        this.#velocity.x = c * CELL + CELL / 2;
        this.#velocity.y = r * CELL + CELL / 2;
        Body.setPosition(block, this.#velocity);
        this.#near.push(block);
      }
    }
  }
}

/** What touches the body, in the order given. The library's own query does the same for bodies of parts. */
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

/** Corners of the polygon whose sides touch the disc, by the project's own sine and cosine. */
function discVertices(): { x: number; y: number }[] {
  const vector = new Float64Array(2);
  writeUnitVector(180 / SIDES, vector);
  const cornerRadius = ROBOT_RADIUS / Math.abs(vector[1] ?? 1);
  return Array.from({ length: SIDES }, (_, side) => {
    writeUnitVector(((side + 0.5) * 360) / SIDES, vector);
    return { x: (vector[0] ?? 0) * cornerRadius, y: (vector[1] ?? 0) * cornerRadius };
  });
}
