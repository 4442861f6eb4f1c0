/** Hints of a mission, opened one after the other; beside their button stands what else can be done. */
import { Lightbulb } from "lucide-react";
import { useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
import styles from "./lessons.module.css";

interface MissionHintsProps {
  hints: readonly string[];
  /** the other buttons of the row */
  children: ReactNode;
}

export function MissionHints({ hints, children }: MissionHintsProps) {
  const { t } = useTranslation("missions", { useSuspense: false });
  const [shown, setShown] = useState(0);
  return (
    <>
      {/* Spoken as they come. */}
      <ol className={styles["hintList"]} aria-live="polite">
        {hints.slice(0, shown).map((hint, at) => (
          <li key={hint} className={styles["hint"]}>
            <span className={styles["hintNumber"]}>{t("card.hintLabel", { number: at + 1 })}</span>{" "}
            {hint}
          </li>
        ))}
      </ol>
      <div className={styles["actions"]}>
        {shown < hints.length && (
          <Button
            size="small"
            icon={<Lightbulb aria-hidden="true" />}
            onClick={() => setShown(shown + 1)}
          >
            {shown === 0
              ? t("card.hint")
              : t("card.nextHint", { number: shown + 1, all: hints.length })}
          </Button>
        )}
        {children}
      </div>
    </>
  );
}
