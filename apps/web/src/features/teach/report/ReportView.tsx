/** Shows the figures of a class from its tables, as the thesis of 2013 does. */
import { reportOf, studyCsv, type Report, type Study } from "@corridor/report";
import { FileDown, FolderOpen, Printer } from "lucide";
import { useMemo, useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../../ui/Button.tsx";
import { DropView } from "../../../ui/DropView.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { chooseFiles, type TextFile } from "../../../ui/incoming-files.ts";
import { saveFile } from "../../../ui/save-file.ts";
import { REPORT_HASH, SavedReports } from "../../../model/teaching/saved-reports.ts";
import { StudentTable } from "./StudentTable.tsx";
import { SavedReportList } from "./SavedReportList.tsx";
import { SavedLessons } from "../../../model/teaching/saved-lessons.ts";
import { questionTexts, type QuestionText } from "./question-texts.ts";
import { ReportHead } from "./ReportHead.tsx";
import {
  addReportFiles,
  openReport,
  savedFileName,
  studyOf,
  type ReadFiles,
} from "./report-files.ts";
import { ReportProblems } from "./ReportProblems.tsx";
import { SurveyTable } from "./SurveyTable.tsx";
import { TaskFigures } from "./TaskFigures.tsx";
import { TaskTables } from "./TaskTables.tsx";
import styles from "./report.module.css";

const definitions = [
  "time",
  "solved",
  "median",
  "deviation",
  "few",
  "lines",
  "attempts",
  "failedChecks",
  "hints",
  "mistakes",
  "unknown",
] as const;

const TABLES = ".csv,.txt,text/csv,text/plain";

interface ReportViewProps {
  /** localStorage */
  device: KeyValueStorage;
  /** id of a report of this device that opens at once; null: none */
  saved: string | null;
}

export function ReportView({ device, saved }: ReportViewProps) {
  const { t } = useTranslation("report", { useSuspense: false });
  const [reports] = useState(() => new SavedReports(device));
  const [first] = useState(() => openFirst(reports, saved));
  const [{ files, problems }, setRead] = useState<ReadFiles>({
    files: first === null ? [] : [first],
    problems: [],
  });
  const [mistakes, setMistakes] = useState<ReadonlyMap<string, number>>(new Map());
  const study = useMemo(() => studyOf(files), [files]);
  const report = useMemo(() => reportOf(study, mistakes), [study, mistakes]);
  const [lessons] = useState(() => new SavedLessons(device).list().map(({ lesson }) => lesson));
  const texts = useMemo(() => questionTexts(report, lessons), [report, lessons]);
  const add = async (added: readonly TextFile[]): Promise<void> =>
    setRead(await addReportFiles(files, added));
  const isEmpty = files.length === 0;
  return (
    <DropView
      title={t("title")}
      drop={t("drop")}
      onFiles={(added) => void add(added)}
      onText={(text) =>
        void add([{ name: "pasted.csv", size: text.length, text: async () => text }])
      }
    >
      <section className={styles["opener"]} aria-label={t("tables")}>
        {saved !== null && first === null && <p>{t("saved.missing")}</p>}
        {isEmpty ? <p>{t("intro")}</p> : <ReportHead files={files} students={report.students} />}
        <div className={styles["buttons"]}>
          <Button
            kind={isEmpty ? "primary" : "outline"}
            icon={<Icon of={FolderOpen} />}
            onClick={() => chooseFiles((added) => void add(added), TABLES)}
          >
            {t("files")}
          </Button>
          {!isEmpty && (
            <Button
              onClick={() => {
                // The address names the report that was open.
                if (saved !== null) location.hash = REPORT_HASH;
                setRead({ files: [], problems: [] });
                setMistakes(new Map());
              }}
            >
              {t("remove")}
            </Button>
          )}
        </div>
        {isEmpty && <p className={styles["note"]}>{t("drop")}</p>}
      </section>
      <ReportProblems problems={problems} />
      {isEmpty && <SavedReportList reports={reports} />}
      {!isEmpty && (
        <ReportContent
          report={report}
          study={study}
          texts={texts}
          onMistakes={(id, students) => {
            const next = new Map(mistakes);
            if (students === null) next.delete(id);
            else next.set(id, students);
            setMistakes(next);
          }}
          onSave={() => {
            // Spreadsheets expect a byte order mark in UTF-8.
            const text = `\uFEFF${studyCsv(study).join("\r\n")}\r\n`;
            saveFile(new Blob([text], { type: "text/csv" }), savedFileName(files));
          }}
        />
      )}
    </DropView>
  );
}

function openFirst(reports: SavedReports, id: string | null) {
  const report = id === null ? null : reports.read(id);
  return report === null ? null : openReport(report);
}

interface ReportContentProps {
  report: Report;
  study: Study;
  /** the texts of the questions, by their ids */
  texts: ReadonlyMap<string, QuestionText>;
  /** @param students null: not counted */
  onMistakes: (question: string, students: number | null) => void;
  onSave: () => void;
}

function ReportContent({ report, study, texts, onMistakes, onSave }: ReportContentProps) {
  const { t } = useTranslation("report", { useSuspense: false });
  const { students, tasks, questions } = report;
  return (
    <>
      {tasks.length > 0 && <TaskTables tasks={tasks} students={students} />}
      {tasks.length > 0 && <TaskFigures tasks={tasks} />}
      <StudentTable study={study} tasks={tasks.map(({ task }) => task)} />
      {questions.length > 0 && (
        <SurveyTable
          questions={questions}
          texts={texts}
          students={students}
          onMistakes={onMistakes}
        />
      )}
      <section className={styles["definitions"]} aria-label={t("definitions.title")}>
        <h3 className={styles["heading"]}>{t("definitions.title")}</h3>
        <ul>
          {definitions.map((each) => (
            <li key={each}>{t(`definitions.${each}`)}</li>
          ))}
          {tasks.some(({ paper }) => paper !== null) && <li>{t("definitions.menus")}</li>}
        </ul>
      </section>
      <div className={styles["buttons"]}>
        <Button icon={<Icon of={Printer} />} onClick={() => window.print()}>
          {t("print")}
        </Button>
        <Button icon={<Icon of={FileDown} />} onClick={onSave}>
          {t("csv")}
        </Button>
      </div>
    </>
  );
}
