/** Saves what the class has done as a table that `/teach#report` opens. */
import { useTranslation } from "react-i18next";
import { fileName } from "../../ui/file-name.ts";
import { saveFile } from "../../ui/save-file.ts";
import { useContent, useStudentName } from "./dashboard-context.ts";

/** @param label of the class; may be empty @returns a function that saves the table */
export function useReport(label: string): () => Promise<void> {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { dashboard } = useContent();
  const nameOf = useStudentName();
  return async () => {
    const { reportCsv } = await import("./report-csv.ts");
    const { lesson, students, verifications } = dashboard.store.getState();
    if (lesson === null) return;
    const csv = reportCsv({
      lesson,
      students: [...students.values()],
      verifications,
      nameOf,
      taskName: (task) => t("card.task", { task }),
    });
    saveFile(
      new Blob([csv], { type: "text/csv" }),
      `${fileName(`${t("class")} ${label}`, "class")}.csv`,
    );
  };
}
