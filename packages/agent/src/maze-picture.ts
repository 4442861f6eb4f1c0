/** Paints a maze as a PNG: blocks, start, goals, and the robot with its heading. */
import { writeUnitVector } from "@corridor/geometry";
import { CELL, isBlock, sizeOf, type Cell, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import { encode } from "fast-png";

/** Longest side in pixels, so that a picture of the largest maze is painted in milliseconds. */
const MAX_PIXELS = 512;
const MAX_PIXELS_PER_CELL = 24;
/** Radius of the robot, in cm. */
const RADIUS = 25;
/** Half of the angle in which the robot's front is marked: the square of its cosine. */
const FRONT = 0.75;

const palette: [number, number, number][] = [
  [255, 255, 255],
  [51, 65, 85],
  [203, 213, 225],
  [34, 160, 90],
  [37, 99, 235],
  [250, 204, 21],
];
const color = { open: 0, block: 1, start: 2, goal: 3, robot: 4, front: 5 } as const;

/** @param pose of the robot; null: none is painted */
export function paintMaze(maze: MazeDocument, pose: Pose | null): Uint8Array {
  const { columns, rows } = sizeOf(maze);
  const longest = Math.max(columns, rows);
  const scale = Math.max(1, Math.min(MAX_PIXELS_PER_CELL, Math.floor(MAX_PIXELS / longest)));
  const width = columns * scale;
  const height = rows * scale;
  const data = new Uint8Array(width * height);
  const fill = ({ column, row }: Cell, index: number): void => {
    for (let y = row * scale; y < (row + 1) * scale; y++) {
      data.fill(index, y * width + column * scale, y * width + (column + 1) * scale);
    }
  };
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      if (isBlock(maze, column, row)) fill({ column, row }, color.block);
    }
  }
  fill(maze.start, color.start);
  for (const goal of maze.goals) fill(goal, color.goal);
  if (pose !== null) paintRobot({ data, width, height, unit: scale / CELL }, pose);
  return encode({ width, height, data, depth: 8, channels: 1, palette });
}

interface Canvas {
  data: Uint8Array;
  width: number;
  height: number;
  /** pixels a cm */
  unit: number;
}

/** A disc whose front is of another colour. On a small scale it is at least one pixel. */
function paintRobot({ data, width, height, unit }: Canvas, { x, y, heading }: Pose): void {
  const [centreX, centreY, radius] = [x * unit, y * unit, Math.max(1, RADIUS * unit)];
  const direction = new Float64Array(2);
  writeUnitVector(heading, direction);
  const [aheadX = 0, aheadY = -1] = direction;
  for (let row = Math.floor(centreY - radius); row <= centreY + radius; row++) {
    for (let column = Math.floor(centreX - radius); column <= centreX + radius; column++) {
      if (row < 0 || column < 0 || row >= height || column >= width) continue;
      const [dx, dy] = [column + 0.5 - centreX, row + 0.5 - centreY];
      const square = dx * dx + dy * dy;
      if (square > radius * radius) continue;
      const ahead = dx * aheadX + dy * aheadY;
      const isFront = ahead > 0 && ahead * ahead > FRONT * square;
      data[row * width + column] = isFront ? color.front : color.robot;
    }
  }
}
