/**
 * planck, a JavaScript port of Box2D, in its fastest configuration for this task: blocks are merged
 * into long rectangles, which are fixtures of one static body, and sensors use `World.rayCast`.
 */
import { CELL, sizeOf, type MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { RobotReport } from "@corridor/protocol";
import { Box, Circle, Vec2, World, type Body } from "planck";
import { DIRECTION_X, DIRECTION_Y, FlatRobot, LINEAR, RADIUS, X, Y } from "./flat-robot.ts";
import { mergedWalls } from "./merged-walls.ts";
import type { Variant } from "./variant.ts";

/** Box2D is tuned for metres. */
const UNITS_PER_METRE = 100;
const TICK_SECONDS = 1 / 60;
const GRAZING = 1e-9;

export class Planck implements Variant {
  readonly #robot: FlatRobot;
  readonly #world = new World({ gravity: { x: 0, y: 0 } });
  readonly #body: Body;
  /** in metres, longer than any free path in the maze */
  readonly #maxRange: number;
  readonly #velocity = Vec2(0, 0);
  readonly #rayEnd = Vec2(0, 0);
  #fraction = 1;
  latest: RobotReport;

  constructor(maze: MazeDocument, program: ProgramDocument) {
    const { columns, rows } = sizeOf(maze);
    this.#robot = new FlatRobot(maze, program);
    this.#maxRange = ((columns + rows) * CELL) / UNITS_PER_METRE;
    const side = CELL / UNITS_PER_METRE;
    const walls = this.#world.createBody();
    for (const wall of mergedWalls(maze)) {
      const halfWidth = (wall.columns * side) / 2;
      const halfHeight = (wall.rows * side) / 2;
      const middle = Vec2(wall.column * side + halfWidth, wall.row * side + halfHeight);
      walls.createFixture({ shape: new Box(halfWidth, halfHeight, middle, 0), friction: 0 });
    }
    const { state } = this.#robot;
    this.#body = this.#world.createBody({
      type: "dynamic",
      position: { x: (state[X] ?? 0) / UNITS_PER_METRE, y: (state[Y] ?? 0) / UNITS_PER_METRE },
      fixedRotation: true,
    });
    this.#body.createFixture({
      shape: new Circle(RADIUS / UNITS_PER_METRE),
      density: 1,
      friction: 0,
    });
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
    const speed = (state[LINEAR] ?? 0) / (UNITS_PER_METRE * TICK_SECONDS);
    this.#velocity.set((state[DIRECTION_X] ?? 0) * speed, (state[DIRECTION_Y] ?? 0) * speed);
    this.#body.setLinearVelocity(this.#velocity);
    this.#world.step(TICK_SECONDS);
    const isStopped = speed !== 0 && this.#applyEngineResult();
    robot.finish(isStopped);
    this.#sense();
    robot.checkGoal();
  }

  /** Copies the body's position from the engine. @returns whether a wall stopped the body */
  #applyEngineResult(): boolean {
    const robot = this.#robot;
    const { state } = robot;
    const { x, y } = this.#body.getPosition();
    const movedX = x * UNITS_PER_METRE - (state[X] ?? 0);
    const movedY = y * UNITS_PER_METRE - (state[Y] ?? 0);
    const distance = Math.sqrt(movedX * movedX + movedY * movedY);
    state[X] = x * UNITS_PER_METRE;
    state[Y] = y * UNITS_PER_METRE;
    for (let edge = this.#body.getContactList(); edge; edge = edge.next ?? null) {
      if (!edge.contact.isTouching()) continue;
      // The normal points from fixture A to fixture B.
      const normal = edge.contact.getWorldManifold(null)?.normal;
      if (normal === undefined) continue;
      const sign = edge.contact.getFixtureA().getBody() === this.#body ? 1 : -1;
      const into = sign * (normal.x * this.#velocity.x + normal.y * this.#velocity.y);
      if (into < GRAZING) continue;
      robot.collide(distance, sign * normal.x, sign * normal.y);
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

  #castRay(directionX: number, directionY: number): number {
    const from = this.#body.getPosition();
    this.#rayEnd.set(from.x + directionX * this.#maxRange, from.y + directionY * this.#maxRange);
    this.#fraction = 1;
    this.#world.rayCast(from, this.#rayEnd, this.#clipRay);
    return this.#fraction * this.#maxRange * UNITS_PER_METRE;
  }

  /** Clips the ray at each hit, so that the last reported hit is the nearest. */
  readonly #clipRay = (_fixture: unknown, _point: unknown, _normal: unknown, fraction: number) => {
    this.#fraction = fraction;
    return fraction;
  };
}
