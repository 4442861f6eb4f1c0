/**
 * The limit: how fast this robot could be in plain JavaScript without any engine. A bare disc on a grid
 * of bytes, with the sensors, rules and motion of the product.
 *
 * Contact is the exact disc against squares, so it stops as the product does at the face of a block and
 * up to 0.03 units later at a block's corner, where the product's disc is a polygon.
 */
import { CELL, gridOf, type Grid, type MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { RobotReport } from "@corridor/protocol";
import type { Contender } from "./contender.ts";
import { FlatRobot, LINEAR, RADIUS, WAY_X, WAY_Y, X, Y } from "./flat-robot.ts";

/** Below this part of the way leading into a block, the robot drives along it and does not touch. */
const GRAZING = 1e-9;

export class Limit implements Contender {
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

  /** The bare loop: nobody looks. */
  runUnseen(ticks: number): void {
    for (let i = 0; i < ticks; i++) this.#step();
  }

  #step(): void {
    const robot = this.#robot;
    robot.plan();
    const isStopped = robot.state[LINEAR] !== 0 && this.#move();
    robot.finish(isStopped);
    this.#sense();
    robot.lookForGoal();
  }

  /** Moves the disc as far as it can before it touches a block. Returns whether one stopped it. */
  #move(): boolean {
    const { state } = this.#robot;
    const { solid, stride } = this.#grid;
    const linear = state[LINEAR] ?? 0;
    const fromX = state[X] ?? 0;
    const fromY = state[Y] ?? 0;
    // Rounded as matter-js rounds: its way is the difference of two positions. A reading often lies at
    // the very number of a rule, and the last bit then decides a tick early or late.
    const x = fromX + (fromX - (fromX - (state[WAY_X] ?? 0) * linear));
    const y = fromY + (fromY - (fromY - (state[WAY_Y] ?? 0) * linear));
    state[X] = x;
    state[Y] = y;
    const column = (x / CELL) | 0;
    const row = (y / CELL) | 0;
    const inX = x - column * CELL;
    const inY = y - row * CELL;
    const sideX = inX < RADIUS ? -1 : inX > CELL - RADIUS ? 1 : 0;
    const sideY = inY < RADIUS ? -1 : inY > CELL - RADIUS ? 1 : 0;
    // The robot's own cell is open: a side of 0 names no wall.
    const here = (Math.imul(row + 1, stride) + column + 1) | 0;
    const next = (here + Math.imul(sideY, stride)) | 0;
    const isWallX = solid[here + sideX] !== 0;
    const isWallY = solid[next] !== 0;
    if (isWallX || isWallY || solid[next + sideX] !== 0) {
      const cornerX = (sideX > 0 ? column + 1 : column) * CELL - x;
      const cornerY = (sideY > 0 ? row + 1 : row) * CELL - y;
      return this.#stop(isWallX ? sideX : 0, isWallY ? sideY : 0, cornerX, cornerY);
    }
    this.#robot.drove(Math.abs(linear));
    return false;
  }

  /**
   * Takes the disc back along its way until it only touches the walls around it.
   * @param wallX, wallY the side of the wall in x and in y, 0 for none; where both are 0 it is a corner's
   * @param cornerX, cornerY from the centre of the disc to the corner of its cell at that side
   */
  #stop(wallX: number, wallY: number, cornerX: number, cornerY: number): boolean {
    const robot = this.#robot;
    const { state } = robot;
    const linear = state[LINEAR] ?? 0;
    const step = Math.abs(linear);
    const wayX = ((state[WAY_X] ?? 0) * linear) / step;
    const wayY = ((state[WAY_Y] ?? 0) * linear) / step;
    let back = 0;
    let normalX = 0;
    let normalY = 0;
    if (wallX * wayX > GRAZING) {
      back = (RADIUS - Math.abs(cornerX)) / (wallX * wayX);
      normalX = wallX;
    }
    if (wallY * wayY > GRAZING && (RADIUS - Math.abs(cornerY)) / (wallY * wayY) > back) {
      back = (RADIUS - Math.abs(cornerY)) / (wallY * wayY);
      normalX = 0;
      normalY = wallY;
    }
    const ahead = cornerX * wayX + cornerY * wayY;
    const overlap = RADIUS * RADIUS - cornerX * cornerX - cornerY * cornerY;
    if (wallX === 0 && wallY === 0 && overlap > 0 && ahead > GRAZING * RADIUS) {
      // Where the distance to the corner is the radius: |corner + way * back| = RADIUS.
      back = Math.sqrt(ahead * ahead + overlap) - ahead;
      normalX = (cornerX + wayX * back) / RADIUS;
      normalY = (cornerY + wayY * back) / RADIUS;
    }
    if (back <= 0) {
      robot.drove(step);
      return false;
    }
    back = Math.min(back, step);
    state[X] = (state[X] ?? 0) - wayX * back;
    state[Y] = (state[Y] ?? 0) - wayY * back;
    robot.ranInto(step - back, normalX, normalY);
    return true;
  }

  /** Four rays through the grid. */
  #sense(): void {
    const { state, readings } = this.#robot;
    const { solid, stride } = this.#grid;
    const x = state[X] ?? 0;
    const y = state[Y] ?? 0;
    const column = (x / CELL) | 0;
    const row = (y / CELL) | 0;
    const here = (Math.imul(row + 1, stride) + column + 1) | 0;
    let wayX = state[WAY_X] ?? 0;
    let wayY = state[WAY_Y] ?? 0;
    for (let sensor = 0; sensor < 4; sensor++) {
      let at = here;
      if (wayX === 0) {
        let next = row;
        if (wayY > 0) {
          while (solid[(at += stride)] === 0) next++;
          readings[sensor] = (next + 1) * CELL - y;
        } else {
          while (solid[(at -= stride)] === 0) next--;
          readings[sensor] = y - next * CELL;
        }
      } else if (wayY === 0) {
        let next = column;
        if (wayX > 0) {
          while (solid[++at] === 0) next++;
          readings[sensor] = (next + 1) * CELL - x;
        } else {
          while (solid[--at] === 0) next--;
          readings[sensor] = x - next * CELL;
        }
      } else {
        const stepX = wayX > 0 ? 1 : -1;
        const stepY = wayY > 0 ? stride : -stride;
        const perColumn = CELL / Math.abs(wayX);
        const perRow = CELL / Math.abs(wayY);
        let alongX = ((wayX > 0 ? column + 1 : column) * CELL - x) / wayX;
        let alongY = ((wayY > 0 ? row + 1 : row) * CELL - y) / wayY;
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
      // The next sensor looks a quarter turn clockwise of this one.
      const turned = -wayY;
      wayY = wayX;
      wayX = turned;
    }
  }
}
