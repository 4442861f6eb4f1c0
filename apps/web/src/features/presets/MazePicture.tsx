/** A maze in small: walls, start and goals, drawn from the document. Decoration beside its name. */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import { blocksPath, edgesPath } from "./maze-outline.ts";
import styles from "./maze-picture.module.css";

/** Radius of the start and half the side of a goal, in cells. */
const MARK = 0.3;

export function MazePicture({ maze }: { maze: MazeDocument }) {
  const { columns, rows } = sizeOf(maze);
  return (
    <svg
      className={styles["picture"]}
      viewBox={`0 0 ${columns} ${rows}`}
      preserveAspectRatio="xMidYMid meet"
      aria-hidden="true"
    >
      <rect className={styles["floor"]} width={columns} height={rows} />
      <path className={styles["blocks"]} d={blocksPath(maze)} />
      <path className={styles["edges"]} d={edgesPath(maze)} />
      <rect className={styles["edges"]} width={columns} height={rows} />
      {maze.goals.map(({ column, row }) => (
        <rect
          key={`${column},${row}`}
          className={styles["goal"]}
          x={column + 0.5 - MARK}
          y={row + 0.5 - MARK}
          width={2 * MARK}
          height={2 * MARK}
        />
      ))}
      <circle
        className={styles["start"]}
        cx={maze.start.column + 0.5}
        cy={maze.start.row + 0.5}
        r={MARK}
      />
    </svg>
  );
}
