/** Hints of a mission, opened one after the other: their button in the card's head, and the list of those open. */
import { Lightbulb } from "lucide-react";
import { useTranslation } from "react-i18next";
import { IconButton } from "../../ui/Button.tsx";
import styles from "./lessons.module.css";

interface HintButtonProps {
  /** how many are open */
  shown: number;
  count: number;
  onShow: () => void;
}

/** Gone when all are open. */
export function HintButton({ shown, count, onShow }: HintButtonProps) {
  const { t } = useTranslation("missions", { useSuspense: false });
  if (shown >= count) return null;
  return (
    <IconButton
      label={shown === 0 ? t("card.hint") : t("card.nextHint", { number: shown + 1, all: count })}
      onClick={onShow}
    >
      <Lightbulb aria-hidden="true" />
    </IconButton>
  );
}

/** Spoken as they come. */
export function HintList({ hints }: { hints: readonly string[] }) {
  const { t } = useTranslation("missions", { useSuspense: false });
  return (
    <ol className={styles["hintList"]} aria-live="polite">
      {hints.map((hint, at) => (
        <li key={hint} className={styles["hint"]}>
          <span className={styles["hintNumber"]}>{t("card.hintLabel", { number: at + 1 })}</span>{" "}
          {hint}
        </li>
      ))}
    </ol>
  );
}
