/** Adds a task: in a maze of the teacher, or with the tasks of a mission, a file or a link. */
import { MAX_TASKS, type LessonDocument } from "@corridor/challenge";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { Dialog } from "../../../ui/Dialog.tsx";
import { ProblemNote } from "../../../ui/ProblemNote.tsx";
import { Beginnings } from "../make/Beginnings.tsx";
import { useBeginning } from "../make/use-beginning.ts";
import styles from "./add-task-dialog.module.css";
import { useDraft, useLesson } from "./draft-context.ts";

export interface AddTaskDialogProps {
  isOpen: boolean;
  /** localStorage */
  device: KeyValueStorage;
  onAdded: () => void;
  onClose: () => void;
}

export function AddTaskDialog({ isOpen, onClose, ...rest }: AddTaskDialogProps) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  return (
    <Dialog
      isOpen={isOpen}
      onClose={onClose}
      title={t("tasks.addTitle")}
      subtitle={t("tasks.addSubtitle")}
    >
      <AddTask {...rest} />
    </Dialog>
  );
}

function AddTask({ device, onAdded }: Pick<AddTaskDialogProps, "device" | "onAdded">) {
  const { t } = useTranslation(["lessonEditor", "teach"], { useSuspense: false });
  const draft = useDraft();
  const { tasks } = useLesson();
  const [found, setFound] = useState(0);
  const task = t("teach:make.taskName", { number: tasks.length + 1 });
  const add = (lesson: LessonDocument): void => {
    const isAdded = draft.addTasks(lesson.tasks);
    setFound(isAdded ? 0 : lesson.tasks.length);
    if (isAdded) onAdded();
  };
  const beginning = useBeginning(task, add);
  return (
    <div className={styles["beginnings"]}>
      {found > 0 && (
        <ProblemNote>
          <p>{t("lessonEditor:tasks.tooMany", { found, most: MAX_TASKS })}</p>
        </ProblemNote>
      )}
      <Beginnings
        device={device}
        task={task}
        beginning={beginning}
        openLink={t("lessonEditor:tasks.addLinked")}
        hasStudy={false}
        takesDrops={false}
        onBegin={add}
      />
    </div>
  );
}
