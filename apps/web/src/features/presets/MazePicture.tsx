/** A maze in small: walls, start and goals, drawn from the document. Decoration beside its name. */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import { blocksPath, edgesPath } from "./maze-outline.ts";
import styles from "./maze-picture.module.css";

/** Radius of the start and half the side of a goal, in cells of a small maze and as a share of a large one. */
const MARK = 0.3;
const MARK_SHARE = 1 / 50;
/** Above so many cells a side an outline would be all that is seen of a block. */
const OUTLINED_UP_TO = 45;

interface MazePictureProps {
  maze: MazeDocument;
  /** whether it marks where the robot starts */
  showStart?: boolean;
}

export function MazePicture({ maze, showStart = true }: MazePictureProps) {
  const { columns, rows } = sizeOf(maze);
  return (
    <svg
      className={styles["picture"]}
      viewBox={`0 0 ${columns} ${rows}`}
      preserveAspectRatio="xMidYMid meet"
      aria-hidden="true"
    >
      <MazeDrawing maze={maze} showStart={showStart} />
    </svg>
  );
}

/** The same as part of another drawing, one unit for each square. */
export function MazeDrawing({ maze, showStart = true }: MazePictureProps) {
  const { columns, rows } = sizeOf(maze);
  const longest = Math.max(columns, rows);
  const mark = Math.max(MARK, longest * MARK_SHARE);
  const isOutlined = longest <= OUTLINED_UP_TO;
  return (
    <>
      <rect className={styles["floor"]} width={columns} height={rows} />
      <path className={styles[isOutlined ? "blocks" : "solid"]} d={blocksPath(maze)} />
      {isOutlined && <path className={styles["edges"]} d={edgesPath(maze)} />}
      <rect className={styles["edges"]} width={columns} height={rows} />
      {maze.goals.map(({ column, row }) => (
        <rect
          key={`${column},${row}`}
          className={styles["goal"]}
          x={column + 0.5 - mark}
          y={row + 0.5 - mark}
          width={2 * mark}
          height={2 * mark}
        />
      ))}
      {showStart && (
        <circle
          className={styles["start"]}
          cx={maze.start.column + 0.5}
          cy={maze.start.row + 0.5}
          r={mark}
        />
      )}
    </>
  );
}
