/** Times, success and lines of the tasks, and the means of what the class counted. */
import type { TaskReport } from "@corridor/report";
import type { ReactNode } from "react";
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
      <div className={styles["section"]}>
        <h3 className={styles["heading"]}>{t("tasks.title")}</h3>
        <Table label={t("tasks.title")} columns={["task", "solved", ...times, "lines"]}>
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
      </div>
      {counted.length > 0 && (
        <div className={styles["section"]}>
          <h3 className={styles["heading"]}>{t("counts.title")}</h3>
          <Table label={t("counts.title")} columns={["task", ...counts]}>
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
        </div>
      )}
    </>
  );
}

type Column = "task" | "solved" | "lines" | (typeof times)[number] | (typeof counts)[number];

interface TableProps {
  label: string;
  columns: readonly Column[];
  children: ReactNode;
}

function Table({ label, columns, children }: TableProps) {
  const { t } = useTranslation("report", { useSuspense: false });
  return (
    // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- scrolls by keyboard
    <section className={styles["scroll"]} tabIndex={0} aria-label={label}>
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
    </section>
  );
}
