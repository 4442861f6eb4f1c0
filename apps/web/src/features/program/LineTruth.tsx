/** Whether a line's condition is true at the shown moment: a tick or a cross with both numbers. */
import type { Condition } from "@corridor/program";
import { Check, X } from "lucide-react";
import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import type { RunState } from "../../stores/run-store.ts";
import { localNumber } from "../../text/numbers.ts";
import { classNames } from "../../ui/class-names.ts";
import { LiveText } from "../../ui/LiveText.tsx";
import type { TruthAt } from "./line-state.ts";
import styles from "./program.module.css";

interface LineTruthProps {
  /** a line without one does nothing and is skipped */
  condition: Condition | null;
  truth: TruthAt;
}

export function LineTruth({ condition, truth }: LineTruthProps) {
  const { t, i18n } = useTranslation();
  const { run } = useServices();
  const { language } = i18n;
  const isTrue = useStore(run, ({ snapshot }) => truth(snapshot)?.isTrue ?? null);
  const [left, right] = useMemo(
    () =>
      (["left", "right"] as const).map(
        (side) =>
          ({ snapshot }: RunState): string =>
            localNumber(truth(snapshot)?.[side] ?? "", language),
      ),
    [truth, language],
  );
  if (condition === null) {
    return (
      <span className={styles["truth"]}>
        <span className={styles["sides"]}>{t("program.skipped")}</span>
      </span>
    );
  }
  if (isTrue === null || left === undefined || right === undefined) return null;
  return (
    <span className={classNames(styles["truth"], isTrue && styles["true"])}>
      <span className={styles["sides"]}>
        <span className={styles["mark"]}>
          {isTrue ? <Check size={14} aria-hidden="true" /> : <X size={14} aria-hidden="true" />}
          <span className="visually-hidden">{t(isTrue ? "program.true" : "program.false")}</span>
          <LiveText of={run} text={left} />
        </span>{" "}
        <LiveText of={run} text={right} />
      </span>
    </span>
  );
}
