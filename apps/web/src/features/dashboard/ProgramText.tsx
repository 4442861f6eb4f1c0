/** The newest program of a student; the line that decides now is lit. */
import { useTranslation } from "react-i18next";
import { openTask } from "../../model/classroom/standing.ts";
import type { SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import { useDashboard } from "./dashboard-context.ts";
import { ProgramLines } from "./ProgramLines.tsx";
import styles from "./watch-sheet.module.css";

export function ProgramText({ student }: { student: SeenStudent }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const read = useDashboard(({ programs }) => programs.get(student.student));
  const program = read?.task === openTask(student) ? read.program : null;
  if (program === null) {
    return (
      <p className={styles["empty"]}>
        {t(student.programs === 0 ? "watch.noProgram" : "watch.noLines")}
      </p>
    );
  }
  const running = student.tile?.state === "driving" ? student.tile.line : null;
  return <ProgramLines program={program} running={running} />;
}
