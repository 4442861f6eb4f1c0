/** What each student did: the time of each task, and the sums of what the class counted. */
import type { Work } from "@corridor/report";
import { useTranslation } from "react-i18next";
import { clockText, columnName } from "./report-numbers.ts";
import { ReportTable } from "./ReportTable.tsx";
import { studentRows, summed, type StudentRow } from "./student-rows.ts";

interface StudentTableProps {
  work: readonly Work[];
  /** ids of the tasks, in the order of the report */
  tasks: readonly string[];
}

/** Nothing for a table without names. */
export function StudentTable({ work, tasks }: StudentTableProps) {
  const { t } = useTranslation("report", { useSuspense: false });
  const rows = studentRows(work, tasks);
  if (rows.length === 0) return null;
  const timeText = (time: StudentRow["times"][number] | undefined): string => {
    if (time === "unsolved") return t("figures.notSolved");
    return typeof time === "number" ? clockText(time) : "–";
  };
  return (
    <ReportTable
      title={t("perStudent.title")}
      columns={[
        t("perStudent.student"),
        ...tasks.map((task) => t("perStudent.time", { task: columnName(task) })),
        ...summed.map((name) => t(`columns.${name}`)),
      ]}
    >
      {rows.map(({ student, times, sums }) => (
        <tr key={student}>
          <th scope="row" dir="auto">
            {student}
          </th>
          {tasks.map((task, at) => (
            <td key={task}>{timeText(times[at])}</td>
          ))}
          {summed.map((name) => (
            <td key={name}>{sums[name] ?? "–"}</td>
          ))}
        </tr>
      ))}
    </ReportTable>
  );
}
