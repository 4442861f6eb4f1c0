/** Makes a lesson: saves what the teacher begins with, and opens it in the editor. */
import type { LessonDocument } from "@corridor/challenge";
import { useEffect, useEffectEvent, useState } from "react";
import { useTranslation } from "react-i18next";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { MAX_SAVED_LESSONS, SavedLessons } from "../../../model/teaching/saved-lessons.ts";
import { SharedLessons } from "../../../model/teaching/shared-lessons.ts";
import { DropView } from "../../../ui/DropView.tsx";
import { ProblemNote } from "../../../ui/ProblemNote.tsx";
import { lessonHash } from "../frame/teach-view.ts";
import { Beginnings } from "./Beginnings.tsx";
import { beginLesson, beginShared, type Begun } from "./begin-lesson.ts";
import { useBeginning } from "./use-beginning.ts";

interface MakeLessonProps {
  /** localStorage */
  device: KeyValueStorage;
  /** link of a lesson or a maze in the address, which opens at once; null without one */
  link: string | null;
}

export function MakeLesson({ device, link }: MakeLessonProps) {
  const { t, ready } = useTranslation("teach", { useSuspense: false });
  const [lessons] = useState(() => new SavedLessons(device));
  const [refusal, setRefusal] = useState<"full" | "blocked" | null>(null);
  const task = t("make.taskName", { number: 1 });

  function follow(begun: Begun, isLink = false): void {
    setRefusal(begun.ok ? null : begun.code);
    if (!begun.ok) return;
    // Back leads to the page before the link.
    if (isLink) location.replace(lessonHash(begun.id));
    else location.hash = lessonHash(begun.id);
  }

  function open(lesson: LessonDocument, isShared: boolean, isLink = false): void {
    // Students may have it, too.
    if (isShared) new SharedLessons(device).add(lesson);
    follow(beginShared(lessons, lesson), isLink);
  }

  const beginning = useBeginning(task, (lesson, isShared) => open(lesson, isShared));
  const linked = useBeginning(task, (lesson, isShared) => open(lesson, isShared, true));
  const openLink = useEffectEvent((text: string) => void linked.openText(text));
  useEffect(() => {
    // The name of a first task is a text, so it waits until the texts are loaded.
    if (link !== null && ready) openLink(link);
  }, [link, ready]);

  const begin = (lesson: LessonDocument): void => follow(beginLesson(lessons, lesson));
  return (
    <DropView
      title={t("make.title")}
      drop={t("make.drop")}
      onFiles={(files) => void beginning.openFiles(files)}
      onText={(text) => void beginning.openText(text)}
    >
      {refusal !== null && (
        <ProblemNote>
          <p>{t(`make.refusals.${refusal}`, { most: MAX_SAVED_LESSONS })}</p>
        </ProblemNote>
      )}
      <Beginnings
        device={device}
        task={task}
        beginning={{
          ...beginning,
          problem: beginning.problem ?? linked.problem,
          isOpening: beginning.isOpening || linked.isOpening,
        }}
        openLink={t("lesson.open")}
        hasStudy
        takesDrops
        onBegin={begin}
      />
    </DropView>
  );
}
