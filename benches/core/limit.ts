/**
 * The limit: an estimate of the fastest possible simulation of this robot in JavaScript. It has no
 * physics engine: a disc on a grid of bytes, with the sensors, rules and motion of the product.
 *
 * Collisions are computed for an exact disc and squares. The product's disc is a polygon, so at the
 * corner of a block the limit stops up to 0.03 units later than the product; at a face, both agree.
 */
import { CELL, gridOf, type Grid, type MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { RobotReport } from "@corridor/protocol";
import { DIRECTION_X, DIRECTION_Y, FlatRobot, LINEAR, RADIUS, X, Y } from "./flat-robot.ts";
import type { Variant } from "./variant.ts";

/** If the cosine between motion and wall normal is smaller, the robot slides along the wall. */
const GRAZING_COSINE = 1e-9;

export class Limit implements Variant {
  readonly #robot: FlatRobot;
  readonly #grid: Grid;
  latest: RobotReport;

  constructor(maze: MazeDocument, program: ProgramDocument) {
    this.#robot = new FlatRobot(maze, program);
    this.#grid = gridOf(maze);
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

  /** Runs ticks without building snapshot objects. */
  runWithoutSnapshots(ticks: number): void {
    for (let i = 0; i < ticks; i++) this.#step();
  }

  #step(): void {
    const robot = this.#robot;
    robot.plan();
    const isStopped = robot.state[LINEAR] !== 0 && this.#move();
    robot.finish(isStopped);
    this.#sense();
    robot.checkGoal();
  }

  /** Moves the disc until it touches a block. @returns whether a block stopped it */
  #move(): boolean {
    const { state } = this.#robot;
    const { solid, stride } = this.#grid;
    const linear = state[LINEAR] ?? 0;
    const fromX = state[X] ?? 0;
    const fromY = state[Y] ?? 0;
    // Rounds as matter-js does, which moves by the difference of two positions. A reading often
    // equals the number of a rule, so a difference in the last bit would change the tick of a
    // decision.
    const x = fromX + (fromX - (fromX - (state[DIRECTION_X] ?? 0) * linear));
    const y = fromY + (fromY - (fromY - (state[DIRECTION_Y] ?? 0) * linear));
    state[X] = x;
    state[Y] = y;
    const column = (x / CELL) | 0;
    const row = (y / CELL) | 0;
    const inX = x - column * CELL;
    const inY = y - row * CELL;
    const sideX = inX < RADIUS ? -1 : inX > CELL - RADIUS ? 1 : 0;
    const sideY = inY < RADIUS ? -1 : inY > CELL - RADIUS ? 1 : 0;
    // The robot's own cell is open, so a side of 0 never finds a wall.
    const here = (Math.imul(row + 1, stride) + column + 1) | 0;
    const next = (here + Math.imul(sideY, stride)) | 0;
    const isWallX = solid[here + sideX] !== 0;
    const isWallY = solid[next] !== 0;
    if (isWallX || isWallY || solid[next + sideX] !== 0) {
      const cornerX = (sideX > 0 ? column + 1 : column) * CELL - x;
      const cornerY = (sideY > 0 ? row + 1 : row) * CELL - y;
      return this.#stop(isWallX ? sideX : 0, isWallY ? sideY : 0, cornerX, cornerY);
    }
    this.#robot.moveFreely(Math.abs(linear));
    return false;
  }

  /**
   * Moves the disc back along its path until it only touches the surrounding walls.
   * @param wallX, wallY side of the wall in x and y, 0 for none; if both are 0, the disc hit a
   * corner
   * @param cornerX, cornerY vector from the centre of the disc to the corner of its cell on that
   * side
   */
  #stop(wallX: number, wallY: number, cornerX: number, cornerY: number): boolean {
    const robot = this.#robot;
    const { state } = robot;
    const linear = state[LINEAR] ?? 0;
    const step = Math.abs(linear);
    const directionX = ((state[DIRECTION_X] ?? 0) * linear) / step;
    const directionY = ((state[DIRECTION_Y] ?? 0) * linear) / step;
    let back = 0;
    let normalX = 0;
    let normalY = 0;
    if (wallX * directionX > GRAZING_COSINE) {
      back = (RADIUS - Math.abs(cornerX)) / (wallX * directionX);
      normalX = wallX;
    }
    if (
      wallY * directionY > GRAZING_COSINE &&
      (RADIUS - Math.abs(cornerY)) / (wallY * directionY) > back
    ) {
      back = (RADIUS - Math.abs(cornerY)) / (wallY * directionY);
      normalX = 0;
      normalY = wallY;
    }
    const ahead = cornerX * directionX + cornerY * directionY;
    const overlap = RADIUS * RADIUS - cornerX * cornerX - cornerY * cornerY;
    if (wallX === 0 && wallY === 0 && overlap > 0 && ahead > GRAZING_COSINE * RADIUS) {
      // Solves for the distance RADIUS from the corner: |corner + direction * back| = RADIUS.
      back = Math.sqrt(ahead * ahead + overlap) - ahead;
      normalX = (cornerX + directionX * back) / RADIUS;
      normalY = (cornerY + directionY * back) / RADIUS;
    }
    if (back <= 0) {
      robot.moveFreely(step);
      return false;
    }
    back = Math.min(back, step);
    state[X] = (state[X] ?? 0) - directionX * back;
    state[Y] = (state[Y] ?? 0) - directionY * back;
    robot.collide(step - back, normalX, normalY);
    return true;
  }

  /** Casts four rays through the grid. */
  #sense(): void {
    const { state, readings } = this.#robot;
    const { solid, stride } = this.#grid;
    const x = state[X] ?? 0;
    const y = state[Y] ?? 0;
    const column = (x / CELL) | 0;
    const row = (y / CELL) | 0;
    const here = (Math.imul(row + 1, stride) + column + 1) | 0;
    let directionX = state[DIRECTION_X] ?? 0;
    let directionY = state[DIRECTION_Y] ?? 0;
    for (let sensor = 0; sensor < 4; sensor++) {
      let at = here;
      if (directionX === 0) {
        let next = row;
        if (directionY > 0) {
          while (solid[(at += stride)] === 0) next++;
          readings[sensor] = (next + 1) * CELL - y;
        } else {
          while (solid[(at -= stride)] === 0) next--;
          readings[sensor] = y - next * CELL;
        }
      } else if (directionY === 0) {
        let next = column;
        if (directionX > 0) {
          while (solid[++at] === 0) next++;
          readings[sensor] = (next + 1) * CELL - x;
        } else {
          while (solid[--at] === 0) next--;
          readings[sensor] = x - next * CELL;
        }
      } else {
        const stepX = directionX > 0 ? 1 : -1;
        const stepY = directionY > 0 ? stride : -stride;
        const perColumn = CELL / Math.abs(directionX);
        const perRow = CELL / Math.abs(directionY);
        let alongX = ((directionX > 0 ? column + 1 : column) * CELL - x) / directionX;
        let alongY = ((directionY > 0 ? row + 1 : row) * CELL - y) / directionY;
        for (;;) {
          if (alongX < alongY) {
            at = (at + stepX) | 0;
            if (solid[at] !== 0) {
              readings[sensor] = alongX;
              break;
            }
            alongX += perColumn;
          } else {
            at = (at + stepY) | 0;
            if (solid[at] !== 0) {
              readings[sensor] = alongY;
              break;
            }
            alongY += perRow;
          }
        }
      }
      // The next sensor points 90 degrees clockwise of this one.
      const turned = -directionY;
      directionY = directionX;
      directionX = turned;
    }
  }
}
