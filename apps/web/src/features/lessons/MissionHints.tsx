/**
 * Hints of a mission, opened one after the other: the button in the card's head and the list of
 * open hints.
 */
import { Lightbulb } from "lucide";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import { IconButton } from "../../ui/Button.tsx";
import { TeacherText } from "./TeacherText.tsx";
import styles from "./mission-hints.module.css";

interface HintButtonProps {
  /** number of open hints */
  shown: number;
  count: number;
  onShow: () => void;
}

/** Disappears when all hints are open. */
export function HintButton({ shown, count, onShow }: HintButtonProps) {
  const { t } = useTranslation("missions", { useSuspense: false });
  if (shown >= count) return null;
  return (
    <IconButton
      label={shown === 0 ? t("card.hint") : t("card.nextHint", { number: shown + 1, all: count })}
      onClick={onShow}
    >
      <Icon of={Lightbulb} />
    </IconButton>
  );
}

interface HintListProps {
  hints: readonly string[];
  /** language of the lesson; null: that of the page */
  language: string | null;
}

/** A live region, so that screen readers announce each new hint. */
export function HintList({ hints, language }: HintListProps) {
  const { t } = useTranslation("missions", { useSuspense: false });
  return (
    <ol className={styles["hintList"]} aria-live="polite">
      {hints.map((hint, at) => (
        <li key={hint} className={styles["hint"]}>
          <span className={styles["hintNumber"]}>{t("card.hintLabel", { number: at + 1 })}</span>{" "}
          <TeacherText text={hint} language={language} />
        </li>
      ))}
    </ol>
  );
}
