/** The rules of the open task: its goal and limits, the lines at the start, and what students may. */
import { MAX_CHECK_BUMPS, MAX_LESSON_SECONDS } from "@corridor/challenge";
import { MAX_RULES } from "@corridor/program";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { Checkbox } from "../../../ui/Checkbox.tsx";
import { NumberField } from "../../../ui/NumberField.tsx";
import { Select } from "../../../ui/Select.tsx";
import { AllowedFields } from "./AllowedFields.tsx";
import { BoundedNumber } from "./BoundedNumber.tsx";
import { useDraft, useOpenTask } from "./draft-context.ts";
import { FormSection } from "./FormSection.tsx";
import styles from "./form.module.css";
import { GoalFields } from "./GoalFields.tsx";
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
        <StartLines lines={lines} />
        <ParFields />
      </FormSection>
      <FormSection title={t("allowed.title")}>
        <AllowedFields />
        <p className={styles["note"]}>{t("allowed.note")}</p>
      </FormSection>
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
      <span className={styles["label"]} aria-hidden="true">
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

/** The numbers of a good solution, which the teacher's own solution sets. */
function ParFields() {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const draft = useDraft();
  const { par, checks } = useOpenTask();
  return (
    <div className={styles["group"]}>
      <Checkbox
        label={t("par.label")}
        note={t("par.note")}
        checked={par !== null}
        onChange={(isSet) => draft.editTask({ par: isSet ? { lines: 2, seconds: 10 } : null })}
      />
      {par !== null && (
        <div className={styles["pair"]}>
          <BoundedNumber
            label={t("par.lines")}
            value={par.lines}
            min={0}
            max={MAX_RULES}
            onChange={(lines) => draft.editTask({ par: { ...par, lines } }, "par lines")}
          />
          <NumberField
            label={t("par.seconds")}
            value={par.seconds}
            bounds={{ min: 0, max: checks.seconds }}
            error={t("number", { min: 0, max: checks.seconds })}
            onChange={(seconds) => draft.editTask({ par: { ...par, seconds } }, "par seconds")}
          />
        </div>
      )}
    </div>
  );
}
