/**
 * planck, the JavaScript Box2D, at its best for this task: blocks merged into long rectangles, all of
 * them fixtures of one static body in its dynamic tree, and sensors by its own ray casts.
 */
import { CELL, sizeOf, type MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { RobotReport } from "@corridor/protocol";
import { Box, Circle, Vec2, World, type Body } from "planck";
import type { Contender } from "./contender.ts";
import { FlatRobot, LINEAR, RADIUS, WAY_X, WAY_Y, X, Y } from "./flat-robot.ts";
import { mergedWalls } from "./merged-walls.ts";

/** Box2D is made for metres. */
const UNITS = 100;
const TICK_SECONDS = 1 / 60;
const GRAZING = 1e-9;

export class Planck implements Contender {
  readonly #robot: FlatRobot;
  readonly #world = new World({ gravity: { x: 0, y: 0 } });
  readonly #body: Body;
  /** longer than any way through the maze, in metres */
  readonly #farAway: number;
  readonly #velocity = Vec2(0, 0);
  readonly #rayEnd = Vec2(0, 0);
  #fraction = 1;
  latest: RobotReport;

  constructor(maze: MazeDocument, program: ProgramDocument) {
    const { columns, rows } = sizeOf(maze);
    this.#robot = new FlatRobot(maze, program);
    this.#farAway = ((columns + rows) * CELL) / UNITS;
    const side = CELL / UNITS;
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
      position: { x: (state[X] ?? 0) / UNITS, y: (state[Y] ?? 0) / UNITS },
      fixedRotation: true,
    });
    this.#body.createFixture({ shape: new Circle(RADIUS / UNITS), density: 1, friction: 0 });
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
    const speed = (state[LINEAR] ?? 0) / (UNITS * TICK_SECONDS);
    this.#velocity.set((state[WAY_X] ?? 0) * speed, (state[WAY_Y] ?? 0) * speed);
    this.#body.setLinearVelocity(this.#velocity);
    this.#world.step(TICK_SECONDS);
    const isStopped = speed !== 0 && this.#settle();
    robot.finish(isStopped);
    this.#sense();
    robot.lookForGoal();
  }

  /** Takes over where the engine left the body, and whether a wall was in its way. */
  #settle(): boolean {
    const robot = this.#robot;
    const { state } = robot;
    const { x, y } = this.#body.getPosition();
    const movedX = x * UNITS - (state[X] ?? 0);
    const movedY = y * UNITS - (state[Y] ?? 0);
    const distance = Math.sqrt(movedX * movedX + movedY * movedY);
    state[X] = x * UNITS;
    state[Y] = y * UNITS;
    for (let edge = this.#body.getContactList(); edge; edge = edge.next ?? null) {
      if (!edge.contact.isTouching()) continue;
      // The normal leads from fixture A to fixture B.
      const normal = edge.contact.getWorldManifold(null)?.normal;
      if (normal === undefined) continue;
      const towards = edge.contact.getFixtureA().getBody() === this.#body ? 1 : -1;
      const into = towards * (normal.x * this.#velocity.x + normal.y * this.#velocity.y);
      if (into < GRAZING) continue;
      robot.ranInto(distance, towards * normal.x, towards * normal.y);
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

  #castRay(wayX: number, wayY: number): number {
    const from = this.#body.getPosition();
    this.#rayEnd.set(from.x + wayX * this.#farAway, from.y + wayY * this.#farAway);
    this.#fraction = 1;
    this.#world.rayCast(from, this.#rayEnd, this.#noteHit);
    return this.#fraction * this.#farAway * UNITS;
  }

  /** Clips the ray at each hit, so that the last one is the nearest. */
  readonly #noteHit = (_fixture: unknown, _point: unknown, _normal: unknown, fraction: number) => {
    this.#fraction = fraction;
    return fraction;
  };
}
