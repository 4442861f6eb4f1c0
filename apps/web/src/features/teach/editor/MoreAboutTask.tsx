/** What most tasks do not need: the line above the maze, and the numbers of a good solution. */
import { MAX_SHORT_LENGTH } from "@corridor/challenge";
import { MAX_RULES } from "@corridor/program";
import { useTranslation } from "react-i18next";
import { Checkbox } from "../../../ui/Checkbox.tsx";
import { NumberField } from "../../../ui/NumberField.tsx";
import { TextField } from "../../../ui/TextField.tsx";
import { BoundedNumber } from "./BoundedNumber.tsx";
import { useDraft, useLesson, useOpenTask } from "./draft-context.ts";
import { FormSection } from "./FormSection.tsx";
import styles from "./form.module.css";

export function MoreAboutTask() {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const draft = useDraft();
  const lang = useLesson().language ?? undefined;
  const { words } = useOpenTask();
  return (
    <FormSection title={t("more.title")}>
      <TextField
        label={t("words.short")}
        note={t("words.shortNote")}
        value={words.short}
        maxLength={MAX_SHORT_LENGTH}
        lang={lang}
        dir="auto"
        onChange={(short) => draft.editTask({ words: { ...draft.task.words, short } }, "short")}
      />
      <ParFields />
    </FormSection>
  );
}

/** The numbers of a good solution, which the teacher's own program sets until the lesson is shared. */
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
