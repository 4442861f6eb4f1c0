/** Times, success and lines of the tasks, and the means of what the class counted. */
import type { TaskReport } from "@corridor/report";
import { useTranslation } from "react-i18next";
import { classNames } from "../../../ui/class-names.ts";
import { clockText, columnName, percentText, shortNumber } from "./report-numbers.ts";
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
      <section className={styles["section"]} aria-label={t("tasks.title")}>
        <h3 className={styles["heading"]}>{t("tasks.title")}</h3>
        <Table columns={["task", "solved", ...times, "lines"]}>
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
        </Table>
        {tasks.map(({ task, time, paper }) =>
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
      </section>
      {counted.length > 0 && (
        <section className={styles["section"]} aria-label={t("counts.title")}>
          <h3 className={styles["heading"]}>{t("counts.title")}</h3>
          <Table columns={["task", ...counts]}>
            {counted.map(({ task, perStudent }) => (
              <tr key={task}>
                <th scope="row">{columnName(task)}</th>
                {counts.map((name) => {
                  const mean = perStudent[name];
                  return <td key={name}>{mean === null ? "–" : shortNumber(mean, language)}</td>;
                })}
              </tr>
            ))}
          </Table>
        </section>
      )}
    </>
  );
}

type Column = "task" | "solved" | "lines" | (typeof times)[number] | (typeof counts)[number];

function Table({ columns, children }: { columns: readonly Column[]; children: React.ReactNode }) {
  const { t } = useTranslation("report", { useSuspense: false });
  return (
    // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- scrolls by keyboard
    <div className={styles["scroll"]} tabIndex={0} role="group" aria-label={t("tables")}>
      <table className={styles["table"]}>
        <thead>
          <tr>
            {columns.map((column) => (
              <th
                key={column}
                scope="col"
                className={classNames(column !== "task" && styles["end"])}
              >
                {t(`columns.${column}`)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>{children}</tbody>
      </table>
    </div>
  );
}
