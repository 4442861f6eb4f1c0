/** A maze with how often robots bumped in each cell. */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import type { ReactNode } from "react";
import { MazeDrawing } from "../../ui/MazePicture.tsx";
import styles from "./bump-maze.module.css";

interface BumpMazeProps {
  maze: MazeDocument;
  bumps: readonly { column: number; row: number; count: number }[];
  /** on top, one unit for each cell */
  children?: ReactNode;
}

export function BumpMaze({ maze, bumps, children }: BumpMazeProps) {
  const { columns, rows } = sizeOf(maze);
  return (
    <svg className={styles["maze"]} viewBox={`0 0 ${columns} ${rows}`} aria-hidden="true">
      <MazeDrawing maze={maze} />
      {bumps.map(({ column, row, count }) => (
        <g key={`${column},${row}`} transform={`translate(${column + 0.5} ${row + 0.5})`}>
          <circle className={styles["bump"]} r={Math.min(0.95, 0.5 + count / 30)} />
          <text className={styles["count"]} y="0.22">
            {count}
          </text>
        </g>
      ))}
      {children}
    </svg>
  );
}
