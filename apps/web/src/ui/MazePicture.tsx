/** A small picture of a maze: walls, start and goals. Decoration beside the name of the maze. */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import { blocksPath, edgesPath } from "./maze-outline.ts";
import styles from "./maze-picture.module.css";

/**
 * Radius of the start, and half the side of a goal: in cells, and as a share of the longest side.
 * The larger value applies.
 */
const MARK = 0.3;
const MARK_SHARE = 1 / 50;
/**
 * Longest side in cells of a maze with outlines. In larger mazes, outlines would hide the blocks.
 */
const OUTLINED_UP_TO = 45;

interface MazePictureProps {
  maze: MazeDocument;
  /** whether the picture marks the start of the robot */
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

/** The same as a part of another SVG, one unit for each cell. */
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
