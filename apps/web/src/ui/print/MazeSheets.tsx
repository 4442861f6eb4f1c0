/** The sheets of a maze that are glued together, each with crop marks and a ruler. */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import { useId } from "react";
import { useTranslation } from "react-i18next";
import { pageName } from "./page-size.ts";
import { PaperMaze } from "./PaperMaze.tsx";
import { MARGIN, OVERLAP, RULER, RULER_ROOM, sheetOf, type PaperName, type Size } from "./paper.ts";
import styles from "./print.module.css";
import { FRAME, type Tiling } from "./tiles.ts";

/** Width of the lines of the maze, in millimetres. */
const LINE = 0.7;
const MM_PER_CM = 10;
/** Length of a crop mark, and its distance from the corner. */
const MARK = 5;
const MARK_GAP = 2;

interface MazeSheetsProps {
  maze: MazeDocument;
  tiling: Tiling;
  /** side of a square, in centimetres */
  square: number;
  paper: PaperName;
}

export function MazeSheets({ maze, tiling, square, paper }: MazeSheetsProps) {
  const { t } = useTranslation("print", { useSuspense: false });
  const clip = useId();
  const { isLandscape, part, columns, rows } = tiling;
  const sheet = sheetOf(paper, isLandscape);
  const side = square * MM_PER_CM;
  const size = sizeOf(maze);
  return tiling.sheets.map(({ column, row, x, y }) => (
    <svg
      key={`${column},${row}`}
      className={styles["sheet"]}
      style={{ page: pageName(isLandscape) }}
      width={`${sheet.width}mm`}
      height={`${sheet.height}mm`}
      viewBox={`0 0 ${sheet.width} ${sheet.height}`}
    >
      <clipPath id={`${clip}-${column}-${row}`}>
        <rect x={MARGIN} y={MARGIN} width={part.width} height={part.height} />
      </clipPath>
      <g clipPath={`url(#${clip}-${column}-${row})`}>
        <g transform={`translate(${MARGIN + FRAME - x} ${MARGIN + FRAME - y}) scale(${side})`}>
          <PaperMaze maze={maze} line={LINE / side} />
        </g>
      </g>
      <CropMarks part={part} />
      {column < columns - 1 && (
        <path
          className={styles["glue"]}
          d={`M${MARGIN + part.width - OVERLAP} ${MARGIN}v${part.height}`}
        />
      )}
      {row < rows - 1 && (
        <path
          className={styles["glue"]}
          d={`M${MARGIN} ${MARGIN + part.height - OVERLAP}h${part.width}`}
        />
      )}
      <Ruler label={t("ruler")} y={sheet.height - MARGIN - RULER_ROOM / 2} />
      <text
        className={styles["place"]}
        x={sheet.width - MARGIN}
        y={sheet.height - MARGIN - RULER_ROOM / 2}
        textAnchor="end"
      >
        {t("sheet", { row: row + 1, column: column + 1, rows, columns })}
      </text>
      <text
        className={styles["place"]}
        x={sheet.width - MARGIN}
        y={sheet.height - MARGIN - RULER_ROOM / 2 + 4}
        textAnchor="end"
      >
        {t("scale", { cm: square, count: size.columns * size.rows })}
      </text>
    </svg>
  ));
}

/** At each corner of the part of the maze, where the sheet is cut. */
function CropMarks({ part }: { part: Size }) {
  const [left, top] = [MARGIN, MARGIN];
  const [right, bottom] = [MARGIN + part.width, MARGIN + part.height];
  let path = "";
  for (const [x, outward] of [
    [left, -1],
    [right, 1],
  ] as const) {
    for (const y of [top, bottom]) path += `M${x + outward * MARK_GAP} ${y}h${outward * MARK}`;
  }
  for (const [y, outward] of [
    [top, -1],
    [bottom, 1],
  ] as const) {
    for (const x of [left, right]) path += `M${x} ${y + outward * MARK_GAP}v${outward * MARK}`;
  }
  return <path className={styles["mark"]} d={path} />;
}

/** 10 cm, to check that the printer did not scale. */
function Ruler({ label, y }: { label: string; y: number }) {
  let ticks = "";
  for (let at = 0; at <= RULER; at += 5) ticks += `M${at} 0v${at % MM_PER_CM === 0 ? -3 : -1.5}`;
  return (
    <g transform={`translate(${MARGIN} ${y})`}>
      <path className={styles["ruler"]} d={`M0 0H${RULER}`} />
      <path className={styles["ruler"]} d={ticks} />
      <text className={styles["place"]} x={RULER / 2} y={4} textAnchor="middle">
        {label}
      </text>
    </g>
  );
}
