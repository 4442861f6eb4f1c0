/** Above the student's page in a trial: what it is, whether the task is solved, and the way back. */
import { ArrowLeft, Check } from "lucide";
import { useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Button } from "../../../ui/Button.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { solutionOf } from "../../../model/teaching/solution.ts";
import { useDraft, useOpenTask } from "./draft-context.ts";
import { useSolutionText } from "./use-solution-text.ts";
import styles from "./trial-band.module.css";

interface TrialBandProps {
  title: string;
  /** whether the trial is to solve the open task */
  isSolving: boolean;
  /** @param task index of a task that is not solved yet */
  onNext: (task: number) => void;
  onClose: () => void;
}

export function TrialBand({ title, isSolving, onNext, onClose }: TrialBandProps) {
  const { t, i18n } = useTranslation("lessonEditor", { useSuspense: false });
  const draft = useDraft();
  const task = useOpenTask();
  const solution = useStore(draft.store, ({ solutions }) => solutionOf(solutions, task));
  const solved = useSolutionText(solution);
  const next = useStore(draft.store, ({ lesson, solutions }) =>
    lesson.tasks.findIndex((each) => solutionOf(solutions, each) === null),
  );
  const region = useRef<HTMLElement>(null);
  useEffect(() => {
    region.current?.focus();
  }, []);
  useEffect(() => {
    document.title = title;
  }, [title, i18n.language]);
  return (
    <section ref={region} className={styles["band"]} aria-label={t("try.label")} tabIndex={-1}>
      <Button size="small" icon={<Icon of={ArrowLeft} isDirectional />} onClick={onClose}>
        {t("try.back")}
      </Button>
      <p>{t(isSolving ? "try.solving" : "try.note")}</p>
      <output className={styles["solved"]}>
        {isSolving && solved !== null && (
          <>
            <Icon of={Check} size={18} />
            {solved}
          </>
        )}
      </output>
      {isSolving && solved !== null && next !== -1 && (
        <Button size="small" onClick={() => onNext(next)}>
          {t("try.next", { task: next + 1 })}
        </Button>
      )}
    </section>
  );
}
