/** The newest program of a student; the line that decides now is lit. */
import { useTranslation } from "react-i18next";
import { openTask } from "../../model/classroom/standing.ts";
import type { SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import { useDashboard } from "./dashboard-context.ts";
import { ProgramLines } from "./ProgramLines.tsx";
import styles from "./watch-sheet.module.css";

export function ProgramText({ student }: { student: SeenStudent }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const task = openTask(student);
  const read = useDashboard(({ programs }) => programs.get(student.student));
  const given = useDashboard(({ lesson }) => lesson?.tasks[task - 1]?.program ?? null);
  const isUnchanged = student.programs === 0;
  const program = isUnchanged ? given : read?.task === task ? read.program : null;
  const running = student.tile?.state === "driving" ? student.tile.line : null;
  return (
    <>
      {isUnchanged && <p className={styles["empty"]}>{t("watch.noProgram")}</p>}
      {program === null && !isUnchanged && <p className={styles["empty"]}>{t("watch.noLines")}</p>}
      {program !== null && <ProgramLines program={program} running={running} />}
    </>
  );
}
