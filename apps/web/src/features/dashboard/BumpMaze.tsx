/** A maze with how often robots bumped in each cell. */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import type { ReactNode } from "react";
import { MazeDrawing } from "../../ui/MazePicture.tsx";
import styles from "./bump-maze.module.css";

/** Longest side in cells of a maze whose cells have room for a number. */
const READABLE_UP_TO = 9;

interface BumpMazeProps {
  maze: MazeDocument;
  bumps: readonly { column: number; row: number; count: number }[];
  /** on top, one unit for each cell */
  children?: ReactNode;
}

export function BumpMaze({ maze, bumps, children }: BumpMazeProps) {
  const { columns, rows } = sizeOf(maze);
  const scale = Math.max(1, Math.max(columns, rows) / READABLE_UP_TO);
  return (
    <svg className={styles["maze"]} viewBox={`0 0 ${columns} ${rows}`} aria-hidden="true">
      <MazeDrawing maze={maze} />
      {bumps.map(({ column, row, count }) => (
        <g
          key={`${column},${row}`}
          transform={`translate(${column + 0.5} ${row + 0.5}) scale(${scale})`}
        >
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
