/**
 * The report of the class: on this device, where the pages for teachers list it, and as a file. Each
 * report of a lesson in the class replaces the one before it.
 */
import { useTranslation } from "react-i18next";
import { lessonName } from "../../model/lessons/lesson-name.ts";
import { reportId, reportName, type SavedReport } from "../../model/teaching/saved-reports.ts";
import { datedFileName } from "../../ui/dated-file-name.ts";
import { saveFile } from "../../ui/save-file.ts";
import { useContent, useStudentName } from "./dashboard-context.ts";

/** Where a report was saved. `id`: of the report on the device; null: the device stores only the file. */
export interface ReportPlace {
  id: string | null;
}

interface ClassReport {
  /** saves the report on the device and as a file; null if the lesson is not known */
  save: () => Promise<ReportPlace | null>;
  /** saves the report on the device, or as a file where the device stores nothing */
  saveOnDevice: () => Promise<ReportPlace | null>;
}

/** @param label of the class; may be empty */
export function useReport(label: string): ClassReport {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { id, dashboard, reports } = useContent();
  const nameOf = useStudentName();

  async function makeReport(): Promise<SavedReport | null> {
    const { reportCsv } = await import("./report-csv.ts");
    const { classroom, lesson, lessonVersion, students, verifications } =
      dashboard.store.getState();
    if (lesson === null || lessonVersion === null) return null;
    const csv = reportCsv({
      lesson,
      students: [...students.values()],
      verifications,
      nameOf,
      taskName: (task) => t("card.task", { task }),
    });
    return {
      id: reportId(id, lessonVersion),
      savedAt: Date.now(),
      label,
      lesson: lessonName(lesson),
      code: classroom?.settings.code ?? "",
      csv,
    };
  }

  function writeFile(report: SavedReport): void {
    const name = datedFileName(reportName(report), report.savedAt, "class");
    saveFile(new Blob([report.csv], { type: "text/csv" }), `${name}.csv`);
  }

  async function saveReport(isAlsoFile: boolean): Promise<ReportPlace | null> {
    const report = await makeReport();
    if (report === null) return null;
    const isStored = reports.write(report);
    if (isAlsoFile || !isStored) writeFile(report);
    return { id: isStored ? report.id : null };
  }

  return { save: async () => saveReport(true), saveOnDevice: async () => saveReport(false) };
}
