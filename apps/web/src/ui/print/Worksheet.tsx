/** One sheet for a student: the maze, the task, its scale, a QR code, and lines to write on. */
import { CELL, sizeOf, type MazeDocument } from "@corridor/maze";
import { useTranslation } from "react-i18next";
import { QrCode } from "../QrCode.tsx";
import { qrPath } from "../qr-path.ts";
import { pageName } from "./page-size.ts";
import { PaperMaze } from "./PaperMaze.tsx";
import type { PaperName } from "./paper.ts";
import styles from "./print.module.css";
import { layOutWorksheet, LINE_HEIGHT, WORKSHEET_MARGIN } from "./worksheet-layout.ts";

/** Width of the lines of the maze, in millimetres. */
const LINE = 0.5;

interface WorksheetProps {
  maze: MazeDocument;
  name: string;
  task: string;
  /** of the teacher's texts; null: that of the page */
  language: string | null;
  /** see `layOutWorksheet` */
  mostLines: number | null;
  /** for the QR code; null without one */
  link: string | null;
  paper: PaperName;
}

export function Worksheet(props: WorksheetProps) {
  const { maze, name, task, language, mostLines, link, paper } = props;
  const { t, i18n } = useTranslation(["print", "words"], { useSuspense: false });
  const { columns, rows } = sizeOf(maze);
  const { isLandscape, sheet, square, lines } = layOutWorksheet(
    { columns, rows },
    paper,
    mostLines,
  );
  const code = link === null ? null : qrPath(link);
  const [width, height] = [columns * square, rows * square];
  return (
    <article
      className={styles["sheet"]}
      dir={i18n.dir()}
      style={{
        page: pageName(isLandscape),
        inlineSize: `${sheet.width}mm`,
        blockSize: `${sheet.height}mm`,
        padding: `${WORKSHEET_MARGIN}mm`,
      }}
    >
      <header className={styles["head"]}>
        <div className={styles["words"]} lang={language ?? undefined} dir="auto">
          <h1 className={styles["name"]}>{name}</h1>
          <p className={styles["task"]}>{task}</p>
        </div>
        {code !== null && (
          <figure className={styles["code"]}>
            <QrCode code={code} />
            <figcaption>{t("words:share.scan")}</figcaption>
          </figure>
        )}
      </header>
      <svg
        className={styles["maze"]}
        width={`${width + 1}mm`}
        height={`${height + 1}mm`}
        viewBox={`-0.5 -0.5 ${width + 1} ${height + 1}`}
      >
        <g transform={`scale(${square})`}>
          <PaperMaze maze={maze} line={LINE / square} />
        </g>
      </svg>
      <div className={styles["scale"]}>
        <svg width={`${square + 1}mm`} height="3mm" viewBox={`-0.5 -1.5 ${square + 1} 3`}>
          <path className={styles["ruler"]} d={`M0 -1v2M0 0H${square}M${square} -1v2`} />
        </svg>
        {t("print:worksheetScale", { cm: CELL })}
      </div>
      <ol className={styles["lines"]}>
        {Array.from({ length: lines }, (_, at) => (
          <li key={at} className={styles["line"]} style={{ blockSize: `${LINE_HEIGHT}mm` }}>
            <span className={styles["number"]}>{at === lines - 1 ? "" : at + 1}</span>
            {at === lines - 1 ? (
              t("words:program.otherwise")
            ) : (
              <>
                {t(at === 0 ? "words:program.if" : "words:program.elseIf")}
                <span className={styles["blank"]} />
                {t("words:program.then")}
              </>
            )}
            <span className={styles["blank"]} />
          </li>
        ))}
      </ol>
    </article>
  );
}
