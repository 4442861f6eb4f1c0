/** The results of the hand-ins, one row for each hand-in and task. */
import { FileDown } from "lucide";
import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { SavedLessons } from "../../model/teaching/saved-lessons.ts";
import { Button } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { saveFile } from "../../ui/save-file.ts";
import type { HandInCheck } from "./check-hand-ins.ts";
import { HandInTableRow } from "./HandInTableRow.tsx";
import { handInsCsv } from "./hand-ins-csv.ts";
import { hasOtherLesson, otherLessonNames } from "./other-lesson-names.ts";
import styles from "./hand-in-table.module.css";

interface HandInTableProps {
  check: HandInCheck;
  /** lessons of this device, whose codes may be among the hand-ins */
  lessons: Pick<SavedLessons, "list">;
}

export function HandInTable({ check, lessons }: HandInTableProps) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const rows = useStore(check.store, (state) => state.rows);
  const isRunning = useStore(check.store, ({ state }) => state === "running");
  const hasOther = hasOtherLesson(rows);
  const lessonNames = useMemo(() => otherLessonNames(hasOther, lessons), [hasOther, lessons]);
  if (rows.length === 0) return null;
  const tasks = new Set(rows.map(({ checked }) => (checked.ok ? checked.task.number : null)));
  tasks.delete(null);
  const hasTasks = tasks.size > 1;
  return (
    <section className={styles["results"]} aria-label={t("table.caption")}>
      <table className={styles["table"]} data-tasks={hasTasks}>
        <thead>
          <tr>
            <th scope="col">{t("table.number")}</th>
            <th scope="col">{t("table.handIn")}</th>
            {hasTasks && <th scope="col">{t("table.task")}</th>}
            <th scope="col">{t("table.passes")}</th>
            <th scope="col" className={styles["figure"]}>
              {t("table.lines")}
            </th>
            <th scope="col" className={styles["figure"]}>
              {t("table.seconds")}
            </th>
            <th scope="col">{t("table.first")}</th>
            <th scope="col">
              <span className="visually-hidden">{t("table.watch")}</span>
            </th>
            <th scope="col" className={styles["figure"]}>
              {t("table.sameAs")}
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <HandInTableRow
              key={`${row.number} ${row.checked.ok ? row.checked.task.number : ""}`}
              row={row}
              hasTasks={hasTasks}
              lessonNames={lessonNames}
            />
          ))}
        </tbody>
      </table>
      {!isRunning && (
        <Button
          icon={<Icon of={FileDown} />}
          onClick={() =>
            saveFile(new Blob([handInsCsv(rows)], { type: "text/csv" }), "hand-ins.csv")
          }
        >
          {t("table.csv")}
        </Button>
      )}
    </section>
  );
}
