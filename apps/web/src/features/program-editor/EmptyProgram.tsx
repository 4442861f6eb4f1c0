/** Replaces the lines while there are none: the goal, and how to start. */
import { Flag } from "lucide";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import styles from "./empty-program.module.css";
import { useGoalSentence } from "./use-goal-sentence.ts";

export function EmptyProgram() {
  const { t } = useTranslation();
  return (
    <div className={styles["empty"]}>
      <p className={styles["goal"]}>
        <Icon of={Flag} size={18} />
        {useGoalSentence()}
      </p>
      <p className={styles["hint"]}>{t("program.noLines")}</p>
    </div>
  );
}
