/** A program as sentences; the line that decides now is lit. */
import type { ProgramDocument } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import { useTranslation } from "react-i18next";
import { conditionText } from "../../model/advice/condition-text.ts";
import { Badge } from "../../ui/Badge.tsx";
import styles from "./program-lines.module.css";

interface ProgramLinesProps {
  program: ProgramDocument;
  /** null: no line decides now */
  running: LineRef | null;
}

export function ProgramLines({ program, running }: ProgramLinesProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { t: tShared, i18n } = useTranslation();
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
