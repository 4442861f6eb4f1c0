/** The lesson above its open task: its name, its introduction, and the row of its tasks. */
import type { LessonDocument } from "@corridor/challenge";
import { Check, Lock } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import type { LessonsService } from "../../model/lessons/lessons-service.ts";
import { isTaskOpen, isTaskOpened } from "../../model/lessons/task-order.ts";
import { Icon } from "../../ui/Icon.tsx";
import { TeacherText } from "./TeacherText.tsx";
import styles from "./lesson-head.module.css";

interface LessonPartProps {
  lesson: LessonDocument;
  service: LessonsService;
}

export function LessonHead({ lesson, service }: LessonPartProps) {
  const { name, intro, language } = lesson;
  return (
    <div className={styles["lesson"]}>
      {intro === "" ? (
        name !== "" && (
          <TeacherText as="p" className={styles["name"]} text={name} language={language} />
        )
      ) : (
        <Introduction lesson={lesson} />
      )}
      {lesson.tasks.length > 1 && <TaskRow lesson={lesson} service={service} />}
    </div>
  );
}

/** Open in the first task. In the others, the lines need the space. */
function Introduction({ lesson: { name, intro, language } }: Pick<LessonPartProps, "lesson">) {
  const { t } = useTranslation("missions", { useSuspense: false });
  const { challenge } = useServices();
  const isFirst = useStore(challenge, ({ index, solved }) => index === 0 && !solved.includes(true));
  return (
    <details open={isFirst}>
      <summary className={styles["name"]}>
        {name === "" ? t("lesson.introduction") : <TeacherText text={name} language={language} />}
      </summary>
      <TeacherText as="p" className={styles["intro"]} text={intro} language={language} />
    </details>
  );
}

/** From this number of tasks on, the row shows numbers only. */
const MANY = 5;

/** The tasks by number and name: which one is open, which are solved, and which are locked. */
export function TaskRow({ lesson, service }: LessonPartProps) {
  const { t } = useTranslation(["missions", "words"], { useSuspense: false });
  const { challenge } = useServices();
  const open = useStore(challenge, ({ index }) => index);
  const solved = useStore(challenge, (state) => state.solved);
  const openTo = useStore(challenge, (state) => state.openTo);
  const [pressed, setPressed] = useState<number | null>(null);
  const { tasks, language } = lesson;
  const isLocked = (index: number) => !isTaskOpen(lesson, solved, index, openTo);
  const locked = [...(pressed === null ? [] : [pressed]), ...tasks.keys()].find(isLocked);
  return (
    <nav aria-label={t("missions:lesson.tasks")}>
      <ol className={styles["tasks"]} data-many={tasks.length >= MANY}>
        {tasks.map(({ name }, index) => {
          const number = index + 1;
          const state = isLocked(index) ? "locked" : solved[index] === true ? "solved" : "open";
          return (
            <li key={number} className={styles["item"]}>
              <button
                type="button"
                className={styles["task"]}
                data-state={state}
                aria-current={index === open ? "step" : undefined}
                aria-disabled={state === "locked" || undefined}
                title={name}
                onClick={() => {
                  setPressed(index);
                  service.navigation.openTask(index);
                }}
              >
                {state === "solved" && <Icon of={Check} size={16} />}
                {state === "locked" && <Icon of={Lock} size={16} />}
                <span>{number}</span>
                <TeacherText className={styles["taskName"]} text={name} language={language} />
                {state !== "open" && (
                  <span className="visually-hidden"> {t(`missions:lesson.${state}`)}</span>
                )}
              </button>
            </li>
          );
        })}
      </ol>
      <output className={styles["note"]}>
        {locked !== undefined &&
          (isTaskOpened(locked, openTo)
            ? t("missions:lesson.lockedNote", { number: locked + 1, before: locked })
            : t("missions:lesson.closedNote", { number: locked + 1 }))}
      </output>
    </nav>
  );
}
