/** Starts a class with a lesson: the names of the students, and how many will come. */
import { parseLesson, type LessonDocument } from "@corridor/challenge";
import { MAX_STUDENTS } from "@corridor/protocol";
import { useId, useMemo, useState, type SubmitEvent } from "react";
import { useTranslation } from "react-i18next";
import type { ClassRefusal } from "../../../model/classroom/class-calls.ts";
import { MAX_CLASS_LABEL, OwnClasses } from "../../../model/classroom/own-classes.ts";
import { namesOf, startClass } from "../../../model/classroom/start-class.ts";
import { lessonName } from "../../../model/lessons/lesson-name.ts";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { Button } from "../../../ui/Button.tsx";
import { Checkbox } from "../../../ui/Checkbox.tsx";
import { Dialog } from "../../../ui/Dialog.tsx";
import { FieldError } from "../../../ui/FieldError.tsx";
import { readNumber } from "../../../ui/number-text.ts";
import { Select } from "../../../ui/Select.tsx";
import { TextArea } from "../../../ui/TextArea.tsx";
import { TextField } from "../../../ui/TextField.tsx";
import { SavedLessons } from "../../../model/teaching/saved-lessons.ts";
import { SharedLessons } from "../../../model/teaching/shared-lessons.ts";
import { study2013 } from "../lessons/study-2013.ts";
import { unsolvedTasks } from "./unsolved-tasks.ts";
import { shareSizesOf, type Excess } from "../share/share-sizes.ts";
import { useExcessText } from "../share/use-excess-text.ts";
import field from "../../../ui/field.module.css";
import styles from "./start-class-dialog.module.css";

const STUDY = "study";

export interface StartClassDialogProps {
  isOpen: boolean;
  /** null: the teacher chooses one of the device */
  lesson: LessonDocument | null;
  /** localStorage */
  device: KeyValueStorage;
  onClose: () => void;
}

export function StartClassDialog({ isOpen, lesson, device, onClose }: StartClassDialogProps) {
  const { t } = useTranslation("teach", { useSuspense: false });
  return (
    <Dialog
      isOpen={isOpen}
      onClose={onClose}
      title={t("class.title")}
      subtitle={t("class.subtitle")}
      width="narrow"
    >
      {isOpen && <StartClassForm lesson={lesson} device={device} />}
    </Dialog>
  );
}

/** An excess: the lesson is too large, and this is the part to shorten. */
type Problem = ClassRefusal | "names" | "expected" | "lesson" | Excess;

function StartClassForm({ lesson, device }: Pick<StartClassDialogProps, "lesson" | "device">) {
  const { t, i18n } = useTranslation(["teach", "lessonEditor"], { useSuspense: false });
  const [saved] = useState(() =>
    new SavedLessons(device).list().filter((each) => parseLesson(each.lesson).ok),
  );
  const [chosen, setChosen] = useState(saved[0]?.id ?? STUDY);
  const [label, setLabel] = useState("");
  const [hasNames, setHasNames] = useState(false);
  const [names, setNames] = useState("");
  const [expected, setExpected] = useState("");
  const [problem, setProblem] = useState<Problem | null>(null);
  const [isStarting, setStarting] = useState(false);
  const errorId = useId();
  const excessText = useExcessText();

  // Corridor itself has solved the study.
  const own = lesson ?? saved.find(({ id }) => id === chosen)?.lesson ?? null;
  const unsolved = useMemo(() => (own === null ? [] : unsolvedTasks(own, saved)), [own, saved]);
  const isUnsolved = own !== null && unsolved.length === own.tasks.length;

  const lessonToStart = async (): Promise<LessonDocument | null> => {
    if (lesson !== null) return parseLesson(lesson).ok ? lesson : null;
    if (chosen !== STUDY) return saved.find(({ id }) => id === chosen)?.lesson ?? null;
    await i18n.loadNamespaces("missions");
    return study2013(i18n);
  };
  const tryStart = async (): Promise<Problem | null> => {
    const pseudonyms = hasNames ? namesOf(names) : null;
    if (hasNames && pseudonyms === null) return "names";
    const count =
      expected.trim() === ""
        ? null
        : readNumber(expected, { min: 1, max: MAX_STUDENTS, whole: true });
    if (expected.trim() !== "" && count === null) return "expected";
    const started = await lessonToStart();
    if (started === null) return "lesson";
    // A class has the limit of a short link.
    const excess = shareSizesOf(started).excesses.shortLink;
    if (excess !== undefined) return excess;
    const request = { lesson: started, names: pseudonyms, expected: count };
    const result = await startClass(request, (url, each) => fetch(url, each));
    if (!result.ok) return result.problem;
    new SharedLessons(device).add(started);
    const { id, teacherKey, screenKey } = result.value;
    new OwnClasses(device, () => Date.now()).store({
      id,
      key: teacherKey,
      screenKey,
      label: label.trim(),
      startedAt: Date.now(),
      notes: {},
    });
    location.assign(`/class/${id}#${teacherKey}`);
    return null;
  };
  const start = async (event: SubmitEvent): Promise<void> => {
    event.preventDefault();
    // A double click must not start two classes.
    if (isStarting) return;
    setStarting(true);
    setProblem(null);
    const found = await tryStart().catch((): Problem => "offline");
    setProblem(found);
    if (found !== null) setStarting(false);
  };
  return (
    <form className={styles["form"]} noValidate onSubmit={(event) => void start(event)}>
      {lesson?.name.trim() === "" && (
        <p className={styles["note"]}>{t("lessonEditor:warnings.unnamed")}</p>
      )}
      {lesson === null && (
        <label className={styles["stack"]}>
          <span className={field["label"]}>{t("teach:class.lesson")}</span>
          <Select
            label={t("teach:class.lesson")}
            value={chosen}
            options={[
              ...saved.map((each) => ({
                value: each.id,
                label: lessonName(each.lesson) || t("teach:lesson.unnamed"),
              })),
              { value: STUDY, label: t("teach:study.name") },
            ]}
            onChange={setChosen}
          />
        </label>
      )}
      <output className={styles["warning"]}>
        {isUnsolved && t("lessonEditor:share.unsolved")}
        {!isUnsolved &&
          unsolved.length > 0 &&
          t("teach:class.unsolved", { count: unsolved.length, tasks: unsolved.join(", ") })}
      </output>
      <TextField
        label={t("teach:class.label")}
        value={label}
        maxLength={MAX_CLASS_LABEL}
        onChange={setLabel}
      />
      <p className={styles["note"]}>{t("teach:class.labelNote")}</p>
      <TextField
        label={t("teach:class.expected")}
        value={expected}
        inputMode="numeric"
        maxLength={4}
        aria-invalid={problem === "expected"}
        onChange={setExpected}
      />
      <p className={styles["note"]}>{t("teach:class.expectedNote")}</p>
      <Checkbox
        label={t("teach:class.ownNames")}
        note={t("teach:class.ownNamesNote")}
        checked={hasNames}
        onChange={setHasNames}
      />
      {hasNames && (
        <>
          <TextArea
            label={t("teach:class.names")}
            rows={6}
            value={names}
            aria-invalid={problem === "names"}
            onChange={setNames}
          />
          <p className={styles["note"]}>{t("teach:class.namesNote")}</p>
        </>
      )}
      {problem !== null && (
        <FieldError id={errorId}>
          {typeof problem === "string"
            ? t(`teach:class.problem.${problem}`)
            : excessText("class", problem)}
        </FieldError>
      )}
      <div>
        <Button kind="primary" size="large" type="submit" aria-disabled={isStarting}>
          {t("teach:class.start")}
        </Button>
      </div>
    </form>
  );
}
