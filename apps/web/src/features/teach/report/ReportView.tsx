/** Shows the figures of a class from its tables, as the thesis of 2013 does. */
import { reportOf, studyCsv, type Report } from "@corridor/report";
import { FileDown, FolderOpen, Printer } from "lucide";
import { useMemo, useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../../ui/Button.tsx";
import { DropView } from "../../../ui/DropView.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { chooseFiles, type TextFile } from "../../../ui/incoming-files.ts";
import { saveFile } from "../../../ui/save-file.ts";
import { SavedLessons } from "../../../model/teaching/saved-lessons.ts";
import { questionTexts, type QuestionText } from "./question-texts.ts";
import { addReportFiles, studyOf, type ReadFiles } from "./report-files.ts";
import { ReportProblems } from "./ReportProblems.tsx";
import { SurveyTable } from "./SurveyTable.tsx";
import { TaskFigures } from "./TaskFigures.tsx";
import { TaskTables } from "./TaskTables.tsx";
import styles from "./report.module.css";

const TABLES = ".csv,.txt,text/csv,text/plain";

export function ReportView({ device }: { device: KeyValueStorage }) {
  const { t } = useTranslation("report", { useSuspense: false });
  const [{ files, problems }, setRead] = useState<ReadFiles>({ files: [], problems: [] });
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
        <p>{isEmpty ? t("intro") : files.map(({ name }) => name).join(", ")}</p>
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
      {!isEmpty && (
        <ReportContent
          report={report}
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
            saveFile(new Blob([text], { type: "text/csv" }), "report.csv");
          }}
        />
      )}
    </DropView>
  );
}

interface ReportContentProps {
  report: Report;
  /** the texts of the questions, by their ids */
  texts: ReadonlyMap<string, QuestionText>;
  /** @param students null: not counted */
  onMistakes: (question: string, students: number | null) => void;
  onSave: () => void;
}

function ReportContent({ report, texts, onMistakes, onSave }: ReportContentProps) {
  const { t } = useTranslation("report", { useSuspense: false });
  const { students, tasks, questions } = report;
  return (
    <>
      <output className={styles["students"]}>
        {students === 1 ? t("oneStudent") : t("students", { all: students })}
      </output>
      {tasks.length > 0 && <TaskTables tasks={tasks} />}
      {tasks.length > 0 && <TaskFigures tasks={tasks} />}
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
          {(["time", "lines", "attempts", "mistakes", "deviation", "few"] as const).map((each) => (
            <li key={each}>{t(`definitions.${each}`)}</li>
          ))}
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
