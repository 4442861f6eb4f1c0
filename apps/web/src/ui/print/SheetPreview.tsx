/** A small picture of the maze with the sheets that it is printed on. */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import { MazeDrawing } from "../MazePicture.tsx";
import styles from "./print-dialog.module.css";
import { FRAME, printedSize, type Tiling } from "./tiles.ts";

const MM_PER_CM = 10;

interface SheetPreviewProps {
  maze: MazeDocument;
  tiling: Tiling;
  square: number;
}

export function SheetPreview({ maze, tiling, square }: SheetPreviewProps) {
  const { width, height } = printedSize(sizeOf(maze), square);
  const { part, sheets } = tiling;
  const last = sheets.at(-1) ?? { x: 0, y: 0 };
  const whole = [Math.max(width, last.x + part.width), Math.max(height, last.y + part.height)];
  return (
    <svg className={styles["tiles"]} viewBox={`0 0 ${whole.join(" ")}`} aria-hidden="true">
      <g transform={`translate(${FRAME} ${FRAME}) scale(${square * MM_PER_CM})`}>
        <MazeDrawing maze={maze} />
      </g>
      {sheets.map(({ column, row, x, y }) => (
        <rect
          key={`${column},${row}`}
          className={styles["tile"]}
          x={x}
          y={y}
          width={part.width}
          height={part.height}
        />
      ))}
    </svg>
  );
}
