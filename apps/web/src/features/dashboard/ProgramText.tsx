/** The newest program of a student as sentences; the line that decides now is lit. */
import { useTranslation } from "react-i18next";
import { conditionText } from "../../model/advice/condition-text.ts";
import { openTask } from "../../model/classroom/standing.ts";
import type { SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import { Badge } from "../../ui/Badge.tsx";
import { useDashboard } from "./dashboard-context.ts";
import styles from "./watch-sheet.module.css";

export function ProgramText({ student }: { student: SeenStudent }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { t: tShared, i18n } = useTranslation();
  const read = useDashboard(({ programs }) => programs.get(student.student));
  const program = read?.task === openTask(student) ? read.program : null;
  const running = student.tile?.state === "driving" ? student.tile.line : null;
  if (program === null) {
    return (
      <p className={styles["empty"]}>
        {t(student.programs === 0 ? "watch.noProgram" : "watch.noLines")}
      </p>
    );
  }
  return (
    <ol className={styles["lines"]} aria-label={t("watch.program")}>
      {program.rules.map((rule, at) => (
        // oxlint-disable-next-line react/no-array-index-key -- a line has no other identity here
        <li key={at} className={styles["line"]} data-running={running === at}>
          <Badge tone={running === at ? "live" : "rest"}>{at + 1}</Badge>
          <span>
            {rule.when === null
              ? tShared("program.name.nothing")
              : `${tShared("program.if")} ${conditionText(tShared, rule.when, i18n.language)}: `}
            {rule.when !== null && tShared(`program.action.${rule.do}`)}
          </span>
        </li>
      ))}
      <li className={styles["line"]} data-running={running === "default"}>
        <Badge tone={running === "default" ? "live" : "rest"}>{"…"}</Badge>
        <span>
          {`${tShared("program.otherwise")}: `}
          {program.default !== null && tShared(`program.action.${program.default}`)}
        </span>
      </li>
    </ol>
  );
}
