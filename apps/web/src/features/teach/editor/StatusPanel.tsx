/** Whether the teacher solved the open task, and what to know before sharing the lesson. */
import { Check, TriangleAlert } from "lucide";
import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Button } from "../../../ui/Button.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { solutionOf } from "../../../model/teaching/solution.ts";
import { useDraft, useLesson, useOpenTask } from "./draft-context.ts";
import { warningsOf, type LessonWarning } from "./lesson-warnings.ts";
import styles from "./status-panel.module.css";
import { useSolutionText } from "./use-solution-text.ts";

export function StatusPanel({ onSolve }: { onSolve: () => void }) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const draft = useDraft();
  const lesson = useLesson();
  const task = useOpenTask();
  const solutions = useStore(draft.store, (state) => state.solutions);
  const solved = useSolutionText(solutionOf(solutions, task));
  const warnings = useMemo(() => warningsOf(lesson, solutions), [lesson, solutions]);
  return (
    <section className={styles["status"]} aria-label={t("warnings.label")}>
      <div className={styles["solve"]}>
        <Button size="small" onClick={onSolve}>
          {t(solved === null ? "solve.start" : "solve.again")}
        </Button>
        {solved !== null && (
          <p className={styles["solved"]}>
            <Icon of={Check} size={18} />
            {solved}
          </p>
        )}
      </div>
      <p className={styles["note"]}>{t("solve.note")}</p>
      {warnings.length > 0 && (
        <ul className={styles["warnings"]}>
          {warnings.map((warning) => (
            <li
              key={`${warning.task} ${warning.code} ${warning.maze}`}
              className={styles["warning"]}
            >
              <Icon of={TriangleAlert} size={16} />
              <Warning warning={warning} hasTasks={lesson.tasks.length > 1} />
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}

function Warning({ warning, hasTasks }: { warning: LessonWarning; hasTasks: boolean }) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const { code, task, maze } = warning;
  const text = t(`warnings.${code}`, { maze: (maze ?? 0) + 1 });
  const isOfOne = hasTasks && task !== null;
  return <span>{isOfOne ? t("warnings.inTask", { task: task + 1, text }) : text}</span>;
}
