/** The texts of the open task: its name, what to do, and hints. */
import { MAX_HINTS, MAX_TASK_LENGTH, type LessonTask } from "@corridor/challenge";
import { MAX_NAME_LENGTH } from "@corridor/program";
import { Plus, Trash2 } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Button, IconButton } from "../../../ui/Button.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { TextArea } from "../../../ui/TextArea.tsx";
import { TextField } from "../../../ui/TextField.tsx";
import { useFieldFocus } from "../../../ui/use-field-focus.ts";
import { isBlank } from "../../../model/teaching/blank-texts.ts";
import { useDraft, useLesson, useOpenTask } from "./draft-context.ts";
import { FormSection } from "./FormSection.tsx";
import styles from "./form.module.css";
import { useNameFocus } from "./use-name-focus.ts";

interface TaskWordsProps {
  /** whether the task was just added: its name takes the focus */
  isNew: boolean;
  onNamed: () => void;
}

export function TaskWords({ isNew, onNamed }: TaskWordsProps) {
  const { t } = useTranslation(["lessonEditor", "teach"], { useSuspense: false });
  const draft = useDraft();
  const lang = useLesson().language ?? undefined;
  const { name, words } = useOpenTask();
  const number = useStore(draft.store, (state) => state.task) + 1;
  const edit = (change: Partial<LessonTask["words"]>, group: string | null = null) =>
    draft.editTask({ words: { ...draft.task.words, ...change } }, group);
  const nameField = useNameFocus(isNew, onNamed);
  const hintFields = useFieldFocus<number>();
  const addHint = (): void => {
    const { hints } = words;
    const blank = hints.findIndex(isBlank);
    hintFields.focus(blank < 0 ? hints.length : blank);
    if (blank < 0) edit({ hints: [...hints, ""] });
  };
  return (
    <FormSection title={t("teach:tasks.unnamed", { number })}>
      <TextField
        ref={nameField}
        label={t("lessonEditor:words.name")}
        value={name}
        maxLength={MAX_NAME_LENGTH}
        lang={lang}
        dir="auto"
        onChange={(next) => draft.editTask({ name: next }, "name")}
      />
      <TextArea
        label={t("lessonEditor:words.task")}
        value={words.task}
        maxLength={MAX_TASK_LENGTH}
        lang={lang}
        dir="auto"
        onChange={(task) => edit({ task }, "task")}
      />
      {words.hints.map((hint, at) => (
        // oxlint-disable-next-line react/no-array-index-key -- hints have no other identity
        <div key={at} className={styles["removable"]}>
          <TextArea
            ref={hintFields.refOf(at)}
            label={t("lessonEditor:words.hint", { number: at + 1 })}
            value={hint}
            rows={2}
            maxLength={MAX_TASK_LENGTH}
            lang={lang}
            dir="auto"
            onChange={(next) => edit({ hints: words.hints.with(at, next) }, `hint ${at}`)}
          />
          <IconButton
            label={t("lessonEditor:words.removeHint", { number: at + 1 })}
            onClick={() => edit({ hints: words.hints.toSpliced(at, 1) })}
          >
            <Icon of={Trash2} />
          </IconButton>
        </div>
      ))}
      {words.hints.length < MAX_HINTS && (
        <Button
          kind="quiet"
          size="small"
          className={styles["add"]}
          icon={<Icon of={Plus} />}
          onClick={addHint}
        >
          {t("lessonEditor:words.addHint")}
        </Button>
      )}
    </FormSection>
  );
}
