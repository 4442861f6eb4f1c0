/** Prints worksheets, or a maze on sheets to glue together. */
import { sizeOf } from "@corridor/maze";
import { Printer } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../Button.tsx";
import { Dialog } from "../Dialog.tsx";
import { Icon } from "../Icon.tsx";
import { NumberField } from "../NumberField.tsx";
import { Segmented } from "../Segmented.tsx";
import { Select } from "../Select.tsx";
import { MazeSheets } from "./MazeSheets.tsx";
import { pageName } from "./page-size.ts";
import type { PaperName } from "./paper.ts";
import styles from "./print-dialog.module.css";
import type { PrintedContent, PrintedMaze } from "./printed-content.ts";
import { SheetPreview } from "./SheetPreview.tsx";
import { Sheets } from "./Sheets.tsx";
import { MAX_SHEETS, printedSize, squareBounds, tileMaze } from "./tiles.ts";
import { Worksheet } from "./Worksheet.tsx";
import { layOutWorksheet } from "./worksheet-layout.ts";

export interface PrintDialogProps {
  isOpen: boolean;
  onClose: () => void;
  content: PrintedContent;
}

const kinds = ["worksheet", "floor"] as const;
const paperNames = ["a4", "letter"] as const;
const DEFAULT_SQUARE = 5;
const ALL = "all";

/** Countries with Letter paper. */
const letterRegions: readonly string[] = ["US", "CA", "MX"];

export function PrintDialog({ isOpen, onClose, content }: PrintDialogProps) {
  const { t } = useTranslation("print", { useSuspense: false });
  return (
    <Dialog isOpen={isOpen} onClose={onClose} title={t("print")} subtitle={t("subtitle")}>
      <PrintForm content={content} />
    </Dialog>
  );
}

function PrintForm({ content }: { content: PrintedContent }) {
  const { t } = useTranslation("print", { useSuspense: false });
  const [kind, setKind] = useState<(typeof kinds)[number]>("worksheet");
  const [paper, setPaper] = useState<PaperName>(usualPaper);
  const [square, setSquare] = useState(DEFAULT_SQUARE);
  const [chosen, setChosen] = useState(ALL);
  const { mazes } = content;
  const options = mazes.map(({ name, maze }, at) => ({
    value: String(at),
    label: t("numbered", { number: at + 1, name: name || maze.name }),
  }));
  const isFloor = kind === "floor";
  const canAll = !isFloor && mazes.length > 1;
  const index = chosen === ALL ? 0 : Number(chosen);
  const shown = canAll && chosen === ALL ? mazes : mazes.slice(index, index + 1);
  return (
    <div className={styles["form"]}>
      <div className={styles["choices"]}>
        <Segmented
          label={t("kind")}
          value={kind}
          options={kinds.map((value) => ({ value, label: t(`kinds.${value}`) }))}
          onChange={setKind}
        />
        <p className={styles["note"]}>{t(`notes.${kind}`)}</p>
        <Segmented
          label={t("paper")}
          showLabel
          value={paper}
          options={paperNames.map((value) => ({ value, label: t(`papers.${value}`) }))}
          onChange={setPaper}
        />
        {mazes.length > 1 && (
          <Select
            label={t("maze")}
            value={canAll ? chosen : String(index)}
            options={canAll ? [{ value: ALL, label: t("all") }, ...options] : options}
            onChange={setChosen}
          />
        )}
        {isFloor && (
          <NumberField
            label={t("square")}
            value={square}
            bounds={squareBounds}
            error={t("range", squareBounds)}
            onChange={setSquare}
          />
        )}
      </div>
      {isFloor ? (
        shown
          .slice(0, 1)
          .map((each) => <FloorPrint key={index} printed={each} square={square} paper={paper} />)
      ) : (
        <WorksheetPrint content={content} mazes={shown} paper={paper} />
      )}
    </div>
  );
}

interface FloorPrintProps {
  printed: PrintedMaze;
  square: number;
  paper: PaperName;
}

function FloorPrint({ printed: { maze }, square, paper }: FloorPrintProps) {
  const { t } = useTranslation("print", { useSuspense: false });
  const size = sizeOf(maze);
  const tiling = tileMaze(size, square, paper);
  if (!tiling.ok) {
    const { sheets, most } = tiling;
    return (
      <p role="alert" className={styles["refused"]}>
        {most === null
          ? t("tooLarge", { limit: MAX_SHEETS })
          : t("tooMany", { sheets, limit: MAX_SHEETS, most })}
      </p>
    );
  }
  const { width, height } = printedSize(size, square);
  return (
    <div className={styles["result"]}>
      <SheetPreview maze={maze} tiling={tiling} square={square} />
      <p>
        {t("sheets", { count: tiling.sheets.length })}
        {" · "}
        {t("size", { width: Math.round(width / 10), height: Math.round(height / 10) })}
      </p>
      <p className={styles["note"]}>{t("check")}</p>
      <PrintNow />
      <Sheets paper={paper} first={pageName(tiling.isLandscape)}>
        <MazeSheets maze={maze} tiling={tiling} square={square} paper={paper} />
      </Sheets>
    </div>
  );
}

interface WorksheetPrintProps {
  content: PrintedContent;
  mazes: readonly PrintedMaze[];
  paper: PaperName;
}

function WorksheetPrint({ content, mazes, paper }: WorksheetPrintProps) {
  const { t } = useTranslation("print", { useSuspense: false });
  const { language, link } = content;
  const [first] = mazes;
  if (first === undefined) return null;
  const pages = mazes.map(({ maze, name, task, lines }, at) => (
    <Worksheet
      key={at}
      maze={maze}
      name={name || maze.name}
      task={task}
      language={language}
      mostLines={lines}
      link={link}
      paper={paper}
    />
  ));
  const { isLandscape, sheet } = layOutWorksheet(sizeOf(first.maze), paper, first.lines);
  return (
    <div className={styles["result"]}>
      <div
        className={styles["preview"]}
        aria-hidden="true"
        style={{ aspectRatio: `${sheet.width} / ${sheet.height}` }}
        data-lying={isLandscape}
      >
        <div className={styles["scaled"]}>{pages[0]}</div>
      </div>
      <p>{t("sheets", { count: mazes.length })}</p>
      {link === null && <p className={styles["note"]}>{t("noLink")}</p>}
      <PrintNow />
      <Sheets paper={paper} first={pageName(isLandscape)}>
        {pages}
      </Sheets>
    </div>
  );
}

function PrintNow() {
  const { t } = useTranslation("print", { useSuspense: false });
  return (
    <Button kind="primary" icon={<Icon of={Printer} />} onClick={() => window.print()}>
      {t("print")}
    </Button>
  );
}

function usualPaper(): PaperName {
  const { region } = new Intl.Locale(navigator.language);
  return letterRegions.includes(region ?? "") ? "letter" : "a4";
}
