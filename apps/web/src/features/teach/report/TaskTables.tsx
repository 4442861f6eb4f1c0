/** Times, success and lines of the tasks, and the means of what the class counted. */
import type { TaskReport } from "@corridor/report";
import { useTranslation } from "react-i18next";
import { clockText, columnName, percentText, shortNumber } from "./report-numbers.ts";
import { ReportTable } from "./ReportTable.tsx";
import styles from "./report.module.css";

const counts = ["attempts", "runs", "bumps", "failedChecks", "hints", "mistakes"] as const;
const times = ["mean", "median", "deviation", "shortest", "longest"] as const;

export function TaskTables({ tasks }: { tasks: readonly TaskReport[] }) {
  const { t, i18n } = useTranslation("report", { useSuspense: false });
  const { language } = i18n;
  const counted = tasks.filter(({ perStudent }) =>
    Object.values(perStudent).some((mean) => mean !== null),
  );
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
        notes={tasks.map(({ task, time, paper }) =>
          paper?.misprint === null || paper === null || time.mean === null ? null : (
            <p key={task} className={styles["note"]}>
              {t("tasks.misprint", {
                task: columnName(task),
                printed: paper.misprint,
                mean: clockText(time.mean),
              })}
            </p>
          ),
        )}
      >
        {tasks.map(({ task, students, solved, time, lines, paper }) => (
          <tr key={task}>
            <th scope="row">{columnName(task)}</th>
            <td>
              {t("tasks.solvedOf", {
                solved,
                all: students,
                percent: percentText(solved / students, language),
              })}
            </td>
            {times.map((name) => {
              const seconds = time[name];
              return <td key={name}>{seconds === null ? t("few") : clockText(seconds)}</td>;
            })}
            <td>{lines === null ? "–" : linesText(lines, paper)}</td>
          </tr>
        ))}
      </ReportTable>
      {counted.length > 0 && (
        <ReportTable
          title={t("counts.title")}
          columns={(["task", ...counts] as const).map((each) => t(`columns.${each}`))}
        >
          {counted.map(({ task, perStudent }) => (
            <tr key={task}>
              <th scope="row">{columnName(task)}</th>
              {counts.map((name) => {
                const mean = perStudent[name];
                return <td key={name}>{mean === null ? "–" : shortNumber(mean, language)}</td>;
              })}
            </tr>
          ))}
        </ReportTable>
      )}
    </>
  );
}
