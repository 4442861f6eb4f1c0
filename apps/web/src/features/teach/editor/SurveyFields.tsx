/** The questions that students answer after the lesson. */
import { MAX_QUESTION_LENGTH, MAX_SURVEY_QUESTIONS } from "@corridor/challenge";
import { Plus, Trash2 } from "lucide";
import { useTranslation } from "react-i18next";
import { Button, IconButton } from "../../../ui/Button.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { TextArea } from "../../../ui/TextArea.tsx";
import { useFieldFocus } from "../../../ui/use-field-focus.ts";
import { isBlank } from "../../../model/teaching/blank-texts.ts";
import { useDraft, useLesson } from "./draft-context.ts";
import { FormSection } from "./FormSection.tsx";
import styles from "./form.module.css";
import { addQuestion } from "./task-list-edits.ts";

export function SurveyFields() {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const draft = useDraft();
  const { survey, language } = useLesson();
  const fields = useFieldFocus<string>();
  const add = (): void => {
    const blank = survey.find(({ question }) => isBlank(question));
    const next = blank === undefined ? addQuestion(draft.lesson, "") : draft.lesson;
    fields.focus(blank?.id ?? next.survey.at(-1)?.id ?? "");
    if (blank === undefined) draft.edit(next);
  };
  return (
    <FormSection title={t("survey.title")}>
      <p className={styles["note"]}>{t("survey.note")}</p>
      {survey.map(({ id, question }, at) => (
        <div key={id} className={styles["removable"]}>
          <TextArea
            ref={fields.refOf(id)}
            label={t("survey.question", { number: at + 1 })}
            value={question}
            rows={2}
            maxLength={MAX_QUESTION_LENGTH}
            lang={language ?? undefined}
            dir="auto"
            onChange={(next) =>
              draft.edit({ survey: survey.with(at, { id, question: next }) }, `question ${id}`)
            }
          />
          <IconButton
            label={t("survey.remove", { number: at + 1 })}
            onClick={() => draft.edit({ survey: survey.toSpliced(at, 1) })}
          >
            <Icon of={Trash2} />
          </IconButton>
        </div>
      ))}
      {survey.length < MAX_SURVEY_QUESTIONS && (
        <Button
          kind="quiet"
          size="small"
          className={styles["add"]}
          icon={<Icon of={Plus} />}
          onClick={add}
        >
          {t("survey.add")}
        </Button>
      )}
    </FormSection>
  );
}
