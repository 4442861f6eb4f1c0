/**
 * A minimal drawing of maze, trail, robot and beams in three layers. Only the dirty rectangles of
 * the last layer are cleared.
 */
import { isBlock, sizeOf, type MazeDocument } from "@corridor/maze";
import { sensorNames } from "@corridor/protocol";
import { STAGE_PX, type RunFrame } from "./bench-run.ts";

type Context = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

export interface Layers {
  maze: Context;
  trail: Context;
  live: Context;
}

const CELL = 100;

export class Drawing {
  readonly #layers: Layers;
  readonly #scale: number;
  #x = 0;
  #y = 0;
  #dirtyRectangles: number[] = [];

  constructor(layers: Layers, maze: MazeDocument, trail: readonly number[]) {
    this.#layers = layers;
    const { columns, rows } = sizeOf(maze);
    this.#scale = STAGE_PX / (columns * CELL);
    layers.maze.fillStyle = "#c5ced8";
    const side = CELL * this.#scale;
    for (let row = 0; row < rows; row++) {
      for (let column = 0; column < columns; column++) {
        if (isBlock(maze, column, row)) {
          layers.maze.fillRect(column * side, row * side, side, side);
        }
      }
    }
    layers.trail.strokeStyle = "#f7c6a2";
    layers.trail.lineWidth = 3;
    layers.trail.beginPath();
    for (let at = 0; at + 1 < trail.length; at += 2) {
      layers.trail.lineTo((trail[at] ?? 0) * this.#scale, (trail[at + 1] ?? 0) * this.#scale);
    }
    layers.trail.stroke();
    this.#x = trail.at(-2) ?? 0;
    this.#y = trail.at(-1) ?? 0;
  }

  draw({ pose, sensors }: RunFrame): void {
    const { trail, live } = this.#layers;
    const scale = this.#scale;
    trail.beginPath();
    trail.moveTo(this.#x * scale, this.#y * scale);
    trail.lineTo(pose.x * scale, pose.y * scale);
    trail.stroke();
    this.#x = pose.x;
    this.#y = pose.y;

    for (let at = 0; at < this.#dirtyRectangles.length; at += 4) {
      const [x = 0, y = 0, width = 0, height = 0] = this.#dirtyRectangles.slice(at, at + 4);
      live.clearRect(x, y, width, height);
    }
    this.#dirtyRectangles = [];
    const x = pose.x * scale;
    const y = pose.y * scale;
    live.font = "600 14px sans-serif";
    live.strokeStyle = "#c8692f";
    sensorNames.forEach((sensor, at) => {
      const radians = ((pose.heading + 90 * at) * Math.PI) / 180;
      const toX = x + Math.sin(radians) * sensors[sensor] * scale;
      const toY = y - Math.cos(radians) * sensors[sensor] * scale;
      live.beginPath();
      live.moveTo(x, y);
      live.lineTo(toX, toY);
      live.stroke();
      live.fillStyle = "#18212c";
      live.fillText(String(Math.round(sensors[sensor])), toX, toY);
      this.#markDirty(Math.min(x, toX), Math.min(y, toY), Math.abs(toX - x), Math.abs(toY - y));
    });
    live.fillStyle = "#ef6a1a";
    live.beginPath();
    live.arc(x, y, 25 * scale, 0, 2 * Math.PI);
    live.fill();
    this.#markDirty(x - 25 * scale, y - 25 * scale, 50 * scale, 50 * scale);
  }

  /** Adds a dirty rectangle, with a margin for the number at the end of a beam. */
  #markDirty(x: number, y: number, width: number, height: number): void {
    const margin = 20;
    this.#dirtyRectangles.push(
      Math.floor(x - margin),
      Math.floor(y - margin),
      Math.ceil(width + 4 * margin),
      Math.ceil(height + 2 * margin),
    );
  }
}
