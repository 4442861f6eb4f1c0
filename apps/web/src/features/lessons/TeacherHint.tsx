/**
 * The newest hint that the teacher shows, where the full card of the task has no room. The student
 * closes it; the card has it further on.
 */
import { X } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { hasNewHint, openTask } from "../../model/challenge/challenge-store.ts";
import { useServices } from "../../model/use-services.ts";
import { IconButton } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { TeacherText } from "./TeacherText.tsx";
import styles from "./mission-hints.module.css";

export function TeacherHint() {
  const { t } = useTranslation(["missions", "words"], { useSuspense: false });
  const { challenge: store } = useServices();
  const language = useStore(store, (state) => state.lesson?.language ?? null);
  const hint = useStore(store, ({ hints, index }) => hints?.[index] ?? 0);
  const isNew = useStore(store, hasNewHint);
  const text = useStore(store, (state) => openTask(state)?.words.hints[hint - 1]);
  return (
    // The region is always present, so that screen readers announce a new hint.
    <div className={styles["teacher"]} aria-live="polite">
      {text !== undefined && isNew && (
        <>
          <p className={styles["teacherText"]}>
            <span className={styles["hintNumber"]}>
              {t("missions:card.hintLabel", { number: hint })}
            </span>{" "}
            <TeacherText text={text} language={language} />
          </p>
          <IconButton
            label={t("missions:card.closeHint")}
            onClick={() => {
              const { hintsRead, index } = store.getState();
              store.setState({ hintsRead: { ...hintsRead, [index]: hint } });
            }}
          >
            <Icon of={X} />
          </IconButton>
        </>
      )}
    </div>
  );
}
