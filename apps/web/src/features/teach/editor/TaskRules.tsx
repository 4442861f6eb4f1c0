/** The rules of the open task: its goal and limits, who drives, and what students may. */
import { MAX_CHECK_BUMPS, MAX_LESSON_SECONDS } from "@corridor/challenge";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { Select } from "../../../ui/Select.tsx";
import { AllowedFields } from "./AllowedFields.tsx";
import { BoundedNumber } from "./BoundedNumber.tsx";
import { useDraft, useOpenTask } from "./draft-context.ts";
import { DriverFields } from "./DriverFields.tsx";
import { FormSection } from "./FormSection.tsx";
import field from "../../../ui/field.module.css";
import styles from "./form.module.css";
import { GoalFields } from "./GoalFields.tsx";
import { MoreAboutTask } from "./MoreAboutTask.tsx";
import { StartLines } from "./StartLines.tsx";
import { withSeconds } from "./task-edits.ts";

/** @param lines the editor of the lines at the start */
export function TaskRules({ lines }: { lines: ReactNode }) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const draft = useDraft();
  const { checks } = useOpenTask();
  return (
    <>
      <FormSection title={t("goal.title")}>
        <GoalFields />
        <div className={styles["pair"]}>
          <BumpLimit />
          <BoundedNumber
            label={t("checks.seconds")}
            value={checks.seconds}
            min={1}
            max={MAX_LESSON_SECONDS}
            onChange={(seconds) => draft.setTask(withSeconds(draft.task, seconds), "seconds")}
          />
        </div>
      </FormSection>
      <FormSection title={t("allowed.title")}>
        <DriverFields />
        <StartLines lines={lines} />
        <AllowedFields />
        <p className={styles["note"]}>{t("allowed.note")}</p>
      </FormSection>
      <MoreAboutTask />
    </>
  );
}

function BumpLimit() {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const draft = useDraft();
  const { checks } = useOpenTask();
  const { bumps } = checks;
  const kind = bumps === null ? "any" : bumps === 0 ? "none" : "some";
  const edit = (next: number | null, group: string | null = null) =>
    draft.editTask({ checks: { ...draft.task.checks, bumps: next } }, group);
  return (
    <div className={styles["choice"]}>
      <span className={field["label"]} aria-hidden="true">
        {t("checks.bumps")}
      </span>
      <Select
        label={t("checks.bumps")}
        value={kind}
        options={(["none", "some", "any"] as const).map((value) => ({
          value,
          label: t(`checks.${value}`),
        }))}
        onChange={(next) => edit(next === "any" ? null : next === "none" ? 0 : 1)}
      />
      {bumps !== null && bumps > 0 && (
        <BoundedNumber
          label={t("checks.most")}
          value={bumps}
          min={1}
          max={MAX_CHECK_BUMPS}
          onChange={(most) => edit(most, "bumps")}
        />
      )}
    </div>
  );
}
