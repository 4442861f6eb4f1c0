/** The texts of the whole lesson, and their language. */
import { MAX_TASK_LENGTH } from "@corridor/challenge";
import { MAX_NAME_LENGTH } from "@corridor/program";
import { useTranslation } from "react-i18next";
import { languages } from "../../../text/languages.ts";
import { Button } from "../../../ui/Button.tsx";
import { Select } from "../../../ui/Select.tsx";
import { TextArea } from "../../../ui/TextArea.tsx";
import { TextField } from "../../../ui/TextField.tsx";
import { useDraft, useLesson } from "./draft-context.ts";
import { FormSection } from "./FormSection.tsx";
import field from "../../../ui/field.module.css";
import styles from "./form.module.css";
import { useNameFocus } from "./use-name-focus.ts";

interface AboutLessonProps {
  /** whether the lesson is new: its name takes the focus */
  isNew: boolean;
  onNamed: () => void;
  /** opens the task */
  onNext: () => void;
}

export function AboutLesson({ isNew, onNamed, onNext }: AboutLessonProps) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const draft = useDraft();
  const { name, intro, language } = useLesson();
  const nameField = useNameFocus(isNew, onNamed);
  const known: { value: string; label: string }[] = languages.map((each) => ({
    value: each.tag,
    label: each.name,
  }));
  // A lesson from elsewhere may be in a language that the page does not have.
  const other = known.some(({ value }) => value === (language ?? "")) ? [] : [language ?? ""];
  return (
    <FormSection title={t("about.title")}>
      <TextField
        ref={nameField}
        label={t("about.name")}
        value={name}
        maxLength={MAX_NAME_LENGTH}
        lang={language ?? undefined}
        dir="auto"
        onChange={(next) => draft.edit({ name: next }, "lesson name")}
      />
      <TextArea
        label={t("about.intro")}
        value={intro}
        maxLength={MAX_TASK_LENGTH}
        lang={language ?? undefined}
        dir="auto"
        onChange={(next) => draft.edit({ intro: next }, "intro")}
      />
      <div className={styles["choice"]}>
        <span className={field["label"]} aria-hidden="true">
          {t("about.language")}
        </span>
        <Select
          label={t("about.language")}
          value={language ?? ""}
          options={[
            { value: "", label: t("about.pageLanguage") },
            ...other.filter((tag) => tag !== "").map((tag) => ({ value: tag, label: tag })),
            ...known,
          ]}
          onChange={(tag) => draft.edit({ language: tag === "" ? null : tag })}
        />
      </div>
      <Button size="small" className={styles["add"]} onClick={onNext}>
        {t("about.next")}
      </Button>
    </FormSection>
  );
}
