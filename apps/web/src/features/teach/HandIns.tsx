/** Checks the hand-ins of a class: opens a lesson, takes programs, and shows where they fail. */
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { mazeName } from "../../model/check/maze-name.ts";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import { createWorkerPool } from "../../simulator/worker-pool.ts";
import { DropView } from "../../ui/DropView.tsx";
import { HandInCheck } from "./check-hand-ins.ts";
import { CheckProgress } from "./CheckProgress.tsx";
import { HandInFields } from "./HandInFields.tsx";
import { HandInTable } from "./HandInTable.tsx";
import { HandInsWork } from "./hand-ins-work.ts";
import { LessonOpener } from "./LessonOpener.tsx";
import { OpenLesson } from "./OpenLesson.tsx";
import { SavedLessons } from "../../model/teaching/saved-lessons.ts";
import { looksLikeLesson } from "./lessons/read-lesson.ts";
import { readTypedLesson } from "./lessons/read-typed-lesson.ts";
import { TeachStorage } from "./teach-storage.ts";
import { HAND_INS_HASH } from "./frame/teach-view.ts";

interface HandInsProps {
  /** localStorage */
  device: KeyValueStorage;
  /** id of the saved lesson to check; null for the one that was checked last */
  saved: string | null;
}

export function HandIns({ device, saved }: HandInsProps) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const { work, check } = useWork(device);
  const [lessons] = useState(() => new SavedLessons(device));
  const hasLesson = useStore(work.store, ({ lesson }) => lesson !== null);
  const takeText = (text: string): void => {
    if (hasLesson && !looksLikeLesson(text)) work.addLines(text);
    else void work.openAddress(text);
  };
  useEffect(() => {
    if (saved === null) return;
    const lesson = lessons.read(saved)?.lesson;
    if (lesson !== undefined) work.openLesson(lesson);
    // A reload continues with the stored work.
    location.replace(HAND_INS_HASH);
  }, [work, lessons, saved]);
  return (
    <DropView
      title={t("handIns.title")}
      drop={t("handIns.drop")}
      onFiles={(files) => void work.addFiles(files)}
      onText={takeText}
    >
      {hasLesson ? <OpenLesson work={work} /> : <LessonOpener work={work} />}
      {hasLesson && <HandInFields work={work} />}
      {hasLesson && <CheckProgress check={check} />}
      {hasLesson && <HandInTable check={check} lessons={lessons} />}
    </DropView>
  );
}

function useWork(device: KeyValueStorage): { work: HandInsWork; check: HandInCheck } {
  const { i18n } = useTranslation("teach", { useSuspense: false });
  const [parts] = useState(() => {
    const pool = createWorkerPool();
    const check = new HandInCheck(
      pool,
      (action, milliseconds) => setTimeout(action, milliseconds),
      (task, maze) => mazeName(i18n.getFixedT(i18n.language, "check"), task, maze),
    );
    const work = new HandInsWork({
      storage: new TeachStorage(device),
      check,
      readAddress: readTypedLesson,
    });
    return { pool, work, check };
  });
  const { pool } = parts;
  useEffect(() => {
    // Ready before the teacher presses Check.
    pool.open();
    return () => pool.close();
  }, [pool]);
  return parts;
}
