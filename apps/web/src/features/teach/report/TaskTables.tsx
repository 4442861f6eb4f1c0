/** Times, success and lines of the tasks, and the means of what the class counted. */
import type { Mean, StudentShare, TaskReport } from "@corridor/report";
import { useTranslation } from "react-i18next";
import { timeText, columnName, percentText, shortNumber } from "./report-numbers.ts";
import { ReportTable } from "./ReportTable.tsx";
import styles from "./report.module.css";

const counts = ["attempts", "runs", "bumps", "failedChecks", "hints", "mistakes"] as const;
const times = ["mean", "median", "deviation", "shortest", "longest"] as const;

interface TaskTablesProps {
  tasks: readonly TaskReport[];
  /** of the whole report */
  students: number;
}

export function TaskTables({ tasks, students }: TaskTablesProps) {
  const { t, i18n } = useTranslation("report", { useSuspense: false });
  const { language } = i18n;
  const isCounted = tasks.some(({ perStudent }) =>
    Object.values(perStudent).some((mean) => mean !== null),
  );
  const meanText = (mean: Mean, format: (mean: number) => string): string => {
    if (typeof mean === "number") return format(mean);
    return mean === null ? "–" : t("few");
  };
  const shareText = ({ students: solved, share }: StudentShare): string =>
    t("tasks.solvedOf", { solved, all: students, percent: percentText(share, language) });
  const linesText = (count: number, paper: TaskReport["paper"]): string => {
    const lines = t("tasks.linesOf", { count, lines: shortNumber(count, language) });
    return paper === null ? lines : t("tasks.inPaper", { lines, menus: paper.menus });
  };
  return (
    <>
      <ReportTable
        title={t("tasks.title")}
        columns={(["task", "solved", ...times, "lines"] as const).map((each) =>
          t(`columns.${each}`),
        )}
        notes={
          <>
            <p className={styles["note"]}>{t("tasks.note")}</p>
            {tasks.map(({ task, time, paper }) =>
              paper?.misprint === null || paper === null || time.mean === null ? null : (
                <p key={task} className={styles["note"]}>
                  {t("tasks.misprint", {
                    task: columnName(task),
                    printed: paper.misprint,
                    mean: timeText(time.mean),
                  })}
                </p>
              ),
            )}
          </>
        }
      >
        {tasks.map(({ task, solved, time, lines, paper }) => (
          <tr key={task}>
            <th scope="row">{columnName(task)}</th>
            <td>{shareText({ students: solved, share: solved / students })}</td>
            {times.map((name) => {
              const seconds = solved === 0 ? null : (time[name] ?? "too few");
              return <td key={name}>{meanText(seconds, timeText)}</td>;
            })}
            <td>{meanText(lines, (mean) => linesText(mean, paper))}</td>
          </tr>
        ))}
      </ReportTable>
      {isCounted && (
        <ReportTable
          title={t("counts.title")}
          columns={[
            ...(["task", "opened", ...counts] as const).map((each) => t(`columns.${each}`)),
            t("survey.mistakesOf"),
          ]}
          notes={<p className={styles["note"]}>{t("counts.note")}</p>}
        >
          {tasks.map(({ task, opened, perStudent, mistaken }) => (
            <tr key={task}>
              <th scope="row">{columnName(task)}</th>
              <td>{t("counts.openedOf", { opened, all: students })}</td>
              {counts.map((name) => (
                <td key={name}>
                  {meanText(perStudent[name], (mean) => shortNumber(mean, language))}
                </td>
              ))}
              <td>{mistaken === null ? "–" : shareText(mistaken)}</td>
            </tr>
          ))}
        </ReportTable>
      )}
    </>
  );
}
