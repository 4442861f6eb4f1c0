/** The maze as an occupancy grid: one cell a metre, row by row from the bottom. */
import { isBlock, sizeOf, type MazeDocument } from "@corridor/maze";
import { quaternionOf, type Stamp } from "./conversions.ts";

const FREE = 0;
const OCCUPIED = 100;

export function mapMessage(maze: MazeDocument, stamp: Stamp): object {
  const { columns, rows } = sizeOf(maze);
  const data = Array.from({ length: columns * rows }, (_, index) => {
    const row = rows - 1 - Math.floor(index / columns);
    return isBlock(maze, index % columns, row) ? OCCUPIED : FREE;
  });
  return {
    header: { stamp, frame_id: "map" },
    info: {
      map_load_time: stamp,
      resolution: 1,
      width: columns,
      height: rows,
      origin: { position: { x: 0, y: 0, z: 0 }, orientation: quaternionOf(0) },
    },
    data,
  };
}
