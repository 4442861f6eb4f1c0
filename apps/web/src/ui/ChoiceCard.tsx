/** A choice in a list, such as a preset: a picture if it has one, its name, and a hint below. */
import { CircleCheck } from "lucide";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { Icon } from "./Icon.tsx";
import styles from "./choice-card.module.css";

interface ChoiceCardProps {
  title: string;
  hint: string;
  picture?: ReactNode;
  /** whether this preset is open */
  isOpen: boolean;
  isSolved?: boolean;
  onChoose: () => void;
}

export function ChoiceCard({
  title,
  hint,
  picture,
  isOpen,
  isSolved = false,
  onChoose,
}: ChoiceCardProps) {
  const { t } = useTranslation();
  return (
    <li className={styles["item"]}>
      <button
        type="button"
        className={styles["card"]}
        aria-current={isOpen}
        onClick={() => onChoose()}
      >
        {picture !== undefined && <span className={styles["frame"]}>{picture}</span>}
        <span className={styles["title"]}>{title}</span>
        <span className={styles["hint"]}>{hint}</span>
        {isSolved && (
          <span className={styles["solved"]}>
            <Icon of={CircleCheck} size={14} />
            {t("presets.solved")}
          </span>
        )}
      </button>
    </li>
  );
}
