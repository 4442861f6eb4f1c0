/** What each student did: the time of each task, and the sums of what the class counted. */
import type { Study } from "@corridor/report";
import { useTranslation } from "react-i18next";
import { timeText, columnName } from "./report-numbers.ts";
import { ReportTable } from "./ReportTable.tsx";
import { studentRows, summed, type StudentRow } from "./student-rows.ts";

interface StudentTableProps {
  study: Study;
  /** ids of the tasks, in the order of the report */
  tasks: readonly string[];
}

/** Nothing for a survey without names. */
export function StudentTable({ study, tasks }: StudentTableProps) {
  const { t } = useTranslation("report", { useSuspense: false });
  const rows = studentRows(study, tasks);
  if (rows.length === 0) return null;
  const known = summed.filter((name) => rows.some(({ sums }) => sums[name] !== null));
  const cellText = (time: StudentRow["times"][number] | undefined): string => {
    if (time === "unsolved") return t("figures.notSolved");
    return typeof time === "number" ? timeText(time) : "–";
  };
  return (
    <ReportTable
      title={t("perStudent.title")}
      columns={[
        t("perStudent.student"),
        ...tasks.map((task) => t("perStudent.time", { task: columnName(task) })),
        ...known.map((name) => t(`columns.${name}`)),
      ]}
    >
      {rows.map(({ student, times, sums }, at) => (
        // oxlint-disable-next-line react/no-array-index-key -- anonymous students have no other identity
        <tr key={at}>
          <th scope="row" dir="auto">
            {student}
          </th>
          {tasks.map((task, column) => (
            <td key={task}>{cellText(times[column])}</td>
          ))}
          {known.map((name) => (
            <td key={name}>{sums[name] ?? "–"}</td>
          ))}
        </tr>
      ))}
    </ReportTable>
  );
}
