/**
 * matter-js used as in its examples: a world with one static body per block and four border walls,
 * `Engine.update` in each tick, and sensors by `Query.ray` over all bodies.
 */
import { CELL, isBlock, sizeOf, type MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { RobotReport } from "@corridor/protocol";
import Matter from "matter-js";
import { DIRECTION_X, DIRECTION_Y, FlatRobot, LINEAR, RADIUS, X, Y } from "./flat-robot.ts";
import type { Variant } from "./variant.ts";

const { Bodies, Body, Composite, Engine, Query } = Matter;
const TICK_MS = 1000 / 60;
const GRAZING = 1e-9;
/** In units. A ray of the default width of matter-js passes through the seam between two blocks. */
const RAY_WIDTH = 0.001;

export class NaiveMatter implements Variant {
  readonly #robot: FlatRobot;
  readonly #engine = Engine.create({ gravity: { scale: 0 } });
  readonly #walls: Matter.Body[];
  readonly #body: Matter.Body;
  /** in units, longer than any free path in the maze */
  readonly #maxRange: number;
  latest: RobotReport;

  constructor(maze: MazeDocument, program: ProgramDocument) {
    const { columns, rows } = sizeOf(maze);
    this.#robot = new FlatRobot(maze, program);
    this.#walls = wallsOf(maze);
    this.#maxRange = (columns + rows) * CELL;
    const { state } = this.#robot;
    this.#body = Bodies.circle(state[X] ?? 0, state[Y] ?? 0, RADIUS, {
      friction: 0,
      frictionAir: 0,
      frictionStatic: 0,
      inertia: Infinity,
    });
    Composite.add(this.#engine.world, [...this.#walls, this.#body]);
    this.#sense();
    this.latest = this.#robot.report();
  }

  get cell(): number {
    return this.#robot.cell;
  }

  run(ticks: number): void {
    for (let i = 0; i < ticks; i++) {
      this.#step();
      this.latest = this.#robot.report();
    }
  }

  #step(): void {
    const robot = this.#robot;
    const { state } = robot;
    robot.plan();
    const linear = state[LINEAR] ?? 0;
    const dx = (state[DIRECTION_X] ?? 0) * linear;
    const dy = (state[DIRECTION_Y] ?? 0) * linear;
    Body.setVelocity(this.#body, { x: dx, y: dy });
    Engine.update(this.#engine, TICK_MS);
    const isStopped = linear !== 0 && this.#applyEngineResult(dx, dy);
    robot.finish(isStopped);
    this.#sense();
    robot.checkGoal();
  }

  /** Copies the body's position from the engine. @returns whether a wall stopped the body */
  #applyEngineResult(dx: number, dy: number): boolean {
    const robot = this.#robot;
    const { state } = robot;
    const { position } = this.#body;
    const movedX = position.x - (state[X] ?? 0);
    const movedY = position.y - (state[Y] ?? 0);
    const distance = Math.sqrt(movedX * movedX + movedY * movedY);
    state[X] = position.x;
    state[Y] = position.y;
    for (const { isActive, collision } of this.#engine.pairs.list) {
      if (!isActive) continue;
      // The normal of matter-js points from the wall to the robot if the robot is `bodyA`.
      const sign = collision.bodyA === this.#body ? -1 : 1;
      const normalX = sign * collision.normal.x;
      const normalY = sign * collision.normal.y;
      if (normalX * dx + normalY * dy < GRAZING) continue;
      robot.collide(distance, normalX, normalY);
      return true;
    }
    robot.moveFreely(distance);
    return false;
  }

  #sense(): void {
    const { state, readings } = this.#robot;
    let directionX = state[DIRECTION_X] ?? 0;
    let directionY = state[DIRECTION_Y] ?? 0;
    for (let sensor = 0; sensor < 4; sensor++) {
      readings[sensor] = this.#castRay(directionX, directionY);
      const turned = -directionY;
      directionY = directionX;
      directionX = turned;
    }
  }

  /**
   * `Query.ray` returns the walls on the ray without distances, so these are computed from bounds.
   */
  #castRay(directionX: number, directionY: number): number {
    const { position } = this.#body;
    const end = {
      x: position.x + directionX * this.#maxRange,
      y: position.y + directionY * this.#maxRange,
    };
    let nearest = this.#maxRange;
    for (const { bodyA } of Query.ray(this.#walls, position, end, RAY_WIDTH)) {
      nearest = Math.min(nearest, distanceTo(bodyA.bounds, position, directionX, directionY));
    }
    return nearest;
  }
}

/** Distance from a point outside a box to the box, along a ray that hits it. */
function distanceTo(
  { min, max }: Matter.Bounds,
  { x, y }: Matter.Vector,
  directionX: number,
  directionY: number,
): number {
  let distance = 0;
  if (directionX !== 0)
    distance = Math.max(distance, ((directionX > 0 ? min.x : max.x) - x) / directionX);
  if (directionY !== 0)
    distance = Math.max(distance, ((directionY > 0 ? min.y : max.y) - y) / directionY);
  return distance;
}

function wallsOf(maze: MazeDocument): Matter.Body[] {
  const { columns, rows } = sizeOf(maze);
  const width = columns * CELL;
  const height = rows * CELL;
  const half = CELL / 2;
  const options = { isStatic: true };
  const walls = [
    Bodies.rectangle(width / 2, -half, width, CELL, options),
    Bodies.rectangle(width / 2, height + half, width, CELL, options),
    Bodies.rectangle(-half, height / 2, CELL, height, options),
    Bodies.rectangle(width + half, height / 2, CELL, height, options),
  ];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      if (!isBlock(maze, column, row)) continue;
      const x = column * CELL + half;
      walls.push(Bodies.rectangle(x, row * CELL + half, CELL, CELL, options));
    }
  }
  return walls;
}
