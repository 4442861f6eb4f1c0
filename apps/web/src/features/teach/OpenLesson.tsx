/** The open lesson, and the choice of its tasks. */
import type { LessonTask } from "@corridor/challenge";
import { useId } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Button } from "../../ui/Button.tsx";
import { classNames } from "../../ui/class-names.ts";
import { Checkbox } from "../../ui/Checkbox.tsx";
import { MazePicture } from "../../ui/MazePicture.tsx";
import type { HandInsWork } from "./hand-ins-work.ts";
import { lessonName } from "../../model/lessons/lesson-name.ts";
import { LessonProblemNote } from "./lessons/LessonProblemNote.tsx";
import field from "../../ui/field.module.css";
import styles from "./open-lesson.module.css";

export function OpenLesson({ work }: { work: HandInsWork }) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const lesson = useStore(work.store, (state) => state.lesson);
  const problem = useStore(work.store, (state) => state.problem);
  const titleId = useId();
  if (lesson === null) return null;
  const { tasks } = lesson;
  const [first] = tasks;
  const [maze] = first?.mazes ?? [];
  return (
    <section className={styles["lesson"]} aria-labelledby={titleId}>
      <div className={styles["head"]}>
        <span className={styles["picture"]}>
          {maze !== undefined && <MazePicture maze={maze} />}
        </span>
        <div className={styles["words"]}>
          <h3
            id={titleId}
            className={styles["name"]}
            lang={lesson.language ?? undefined}
            dir="auto"
          >
            {lessonName(lesson) || t("lesson.unnamed")}
          </h3>
          <p className={styles["facts"]}>
            {first !== undefined && tasks.length === 1
              ? t("tasks.mazes", mazesOf(first))
              : t("lesson.tasks", { count: tasks.length })}
          </p>
        </div>
        <Button size="small" onClick={() => work.close()}>
          {t("lesson.another")}
        </Button>
      </div>
      {tasks.length > 1 && <TaskChoice work={work} tasks={tasks} />}
      {problem !== null && <LessonProblemNote problem={problem} />}
    </section>
  );
}

function TaskChoice({ work, tasks }: { work: HandInsWork; tasks: readonly LessonTask[] }) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const chosen = useStore(work.store, (state) => state.chosen);
  return (
    <fieldset className={styles["tasks"]}>
      <legend className={classNames(field["label"], styles["legend"])}>{t("tasks.legend")}</legend>
      {tasks.map((task, at) => (
        // oxlint-disable-next-line react/no-array-index-key -- tasks have no other identity
        <Checkbox
          key={at}
          label={t(task.name === "" ? "tasks.unnamed" : "tasks.named", {
            number: at + 1,
            name: task.name,
          })}
          note={t("tasks.mazes", mazesOf(task))}
          checked={chosen[at] ?? false}
          onChange={(isChosen) => work.chooseTask(at, isChosen)}
        />
      ))}
    </fieldset>
  );
}

function mazesOf({ mazes, unseen }: LessonTask): { given: number; unseen: number } {
  return { given: mazes.length, unseen: unseen?.count ?? 0 };
}
