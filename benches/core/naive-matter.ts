/**
 * matter-js as its examples teach it: a world with one static body for every block and four border
 * walls, `Engine.update` on each tick, and sensors by `Query.ray` over all bodies.
 */
import { CELL, isBlock, sizeOf, type MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { RobotReport } from "@corridor/protocol";
import Matter from "matter-js";
import type { Contender } from "./contender.ts";
import { FlatRobot, LINEAR, RADIUS, WAY_X, WAY_Y, X, Y } from "./flat-robot.ts";

const { Bodies, Body, Composite, Engine, Query } = Matter;
const TICK_MS = 1000 / 60;
const GRAZING = 1e-9;
/** In units. A ray of matter-js's own width slips through the seam between two blocks. */
const RAY_WIDTH = 0.001;

export class NaiveMatter implements Contender {
  readonly #robot: FlatRobot;
  readonly #engine = Engine.create({ gravity: { scale: 0 } });
  readonly #walls: Matter.Body[];
  readonly #body: Matter.Body;
  /** longer than any way through the maze, in units */
  readonly #farAway: number;
  latest: RobotReport;

  constructor(maze: MazeDocument, program: ProgramDocument) {
    const { columns, rows } = sizeOf(maze);
    this.#robot = new FlatRobot(maze, program);
    this.#walls = wallsOf(maze);
    this.#farAway = (columns + rows) * CELL;
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
    const dx = (state[WAY_X] ?? 0) * linear;
    const dy = (state[WAY_Y] ?? 0) * linear;
    Body.setVelocity(this.#body, { x: dx, y: dy });
    Engine.update(this.#engine, TICK_MS);
    const isStopped = linear !== 0 && this.#settle(dx, dy);
    robot.finish(isStopped);
    this.#sense();
    robot.lookForGoal();
  }

  /** Takes over where the engine left the body, and whether a wall was in its way. */
  #settle(dx: number, dy: number): boolean {
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
      // matter-js's normal leads from the wall to the robot where the robot is its first body.
      const towards = collision.bodyA === this.#body ? -1 : 1;
      const normalX = towards * collision.normal.x;
      const normalY = towards * collision.normal.y;
      if (normalX * dx + normalY * dy < GRAZING) continue;
      robot.ranInto(distance, normalX, normalY);
      return true;
    }
    robot.drove(distance);
    return false;
  }

  #sense(): void {
    const { state, readings } = this.#robot;
    let wayX = state[WAY_X] ?? 0;
    let wayY = state[WAY_Y] ?? 0;
    for (let sensor = 0; sensor < 4; sensor++) {
      readings[sensor] = this.#castRay(wayX, wayY);
      const turned = -wayY;
      wayY = wayX;
      wayX = turned;
    }
  }

  /** `Query.ray` names the walls on the ray and no distance: that comes from their bounds. */
  #castRay(wayX: number, wayY: number): number {
    const { position } = this.#body;
    const end = { x: position.x + wayX * this.#farAway, y: position.y + wayY * this.#farAway };
    let nearest = this.#farAway;
    for (const { bodyA } of Query.ray(this.#walls, position, end, RAY_WIDTH)) {
      nearest = Math.min(nearest, distanceTo(bodyA.bounds, position, wayX, wayY));
    }
    return nearest;
  }
}

/** From a point outside of a box along a ray that hits it, to the box. */
function distanceTo(
  { min, max }: Matter.Bounds,
  { x, y }: Matter.Vector,
  wayX: number,
  wayY: number,
): number {
  let distance = 0;
  if (wayX !== 0) distance = Math.max(distance, ((wayX > 0 ? min.x : max.x) - x) / wayX);
  if (wayY !== 0) distance = Math.max(distance, ((wayY > 0 ? min.y : max.y) - y) / wayY);
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
