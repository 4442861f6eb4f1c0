/** Whether a line's condition is true at the shown moment: a tick or a cross with both numbers. */
import { Check, X } from "lucide-react";
import { useTranslation } from "react-i18next";
import { localNumber } from "../../text/numbers.ts";
import { classNames } from "../../ui/class-names.ts";
import type { ShownTruth } from "./line-state.ts";
import styles from "./program.module.css";

interface LineTruthProps {
  /** a line without one does nothing and is skipped */
  hasCondition: boolean;
  /** null before the first snapshot */
  truth: ShownTruth | null;
}

export function LineTruth({ hasCondition, truth }: LineTruthProps) {
  const { t, i18n } = useTranslation();
  if (!hasCondition) {
    return <span className={styles["truth"]}>{t("program.skipped")}</span>;
  }
  if (truth === null) return null;
  const { isTrue, left, right } = truth;
  return (
    <span className={classNames(styles["truth"], isTrue && styles["true"])}>
      <span className={styles["mark"]}>
        {isTrue ? <Check size={14} aria-hidden="true" /> : <X size={14} aria-hidden="true" />}
        <span className="visually-hidden">{t(isTrue ? "program.true" : "program.false")}</span>
        {localNumber(left, i18n.language)}
      </span>{" "}
      <span>{localNumber(right, i18n.language)}</span>
    </span>
  );
}
