/** Hints of a mission, opened one after the other. */
import { Lightbulb } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
import styles from "./lessons.module.css";

export function MissionHints({ hints }: { hints: readonly string[] }) {
  const { t } = useTranslation("missions", { useSuspense: false });
  const [shown, setShown] = useState(0);
  return (
    <div className={styles["hints"]}>
      {/* Spoken as they come. */}
      <ol className={styles["hintList"]} aria-live="polite">
        {hints.slice(0, shown).map((hint, at) => (
          <li key={hint} className={styles["hint"]}>
            <span className={styles["hintNumber"]}>{t("card.hintLabel", { number: at + 1 })}</span>{" "}
            {hint}
          </li>
        ))}
      </ol>
      {shown < hints.length && (
        <Button
          kind="quiet"
          size="small"
          className={styles["hintButton"]}
          icon={<Lightbulb aria-hidden="true" />}
          onClick={() => setShown(shown + 1)}
        >
          {shown === 0
            ? t("card.hint")
            : t("card.nextHint", { number: shown + 1, all: hints.length })}
        </Button>
      )}
    </div>
  );
}
