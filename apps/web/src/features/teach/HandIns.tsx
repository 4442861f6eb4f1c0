/** Checks the hand-ins of a class: opens a lesson, takes programs, and shows where they fail. */
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { readShortLink } from "../../model/address/short-link.ts";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import { createWorkerPool } from "../../simulator/worker-pool.ts";
import { DropView } from "../../ui/DropView.tsx";
import { HandInCheck } from "./check-hand-ins.ts";
import { CheckProgress } from "./CheckProgress.tsx";
import { HandInFields } from "./HandInFields.tsx";
import { HandInTable } from "./HandInTable.tsx";
import { HandInsWork } from "./hand-ins-work.ts";
import { LessonOpener } from "./LessonOpener.tsx";
import { mazeName } from "./maze-name.ts";
import { OpenLesson } from "./OpenLesson.tsx";
import { looksLikeLesson, readLessonAddress } from "./read-lesson.ts";
import { TeachStorage } from "./teach-storage.ts";
import { HAND_INS_HASH } from "./teach-view.ts";

/** Interval between two updates of the table. */
const SHOW_MS = 125;
/** Interval of requests while the service delays short links. */
const WAIT_MS = 1_000;

interface HandInsProps {
  /** localStorage */
  device: KeyValueStorage;
  /** link of a lesson in the address, or null */
  link: string | null;
}

export function HandIns({ device, link }: HandInsProps) {
  const { t } = useTranslation("teach", { useSuspense: false });
  const { work, check } = useWork(device);
  const hasLesson = useStore(work.store, ({ lesson }) => lesson !== null);
  const takeText = (text: string): void => {
    if (hasLesson && !looksLikeLesson(text)) work.addLines(text);
    else void work.openAddress(text);
  };
  useEffect(() => {
    if (link === null) return;
    void work.openAddress(link).then(() => {
      // A reload continues with the stored work.
      if (location.hash === `#${link}`) location.replace(HAND_INS_HASH);
    });
  }, [work, link]);
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
      {hasLesson && <HandInTable check={check} />}
    </DropView>
  );
}

function useWork(device: KeyValueStorage): { work: HandInsWork; check: HandInCheck } {
  const { i18n } = useTranslation("teach", { useSuspense: false });
  const [parts] = useState(() => {
    const pool = createWorkerPool();
    const check = new HandInCheck(
      pool,
      (show) => setTimeout(show, SHOW_MS),
      (task, maze) => mazeName(i18n.getFixedT(i18n.language, "teach"), task, maze),
    );
    const readShort = async (id: string) =>
      readShortLink(
        id,
        (url) => fetch(url),
        async () => new Promise((resolve) => setTimeout(resolve, WAIT_MS)),
      );
    const work = new HandInsWork({
      storage: new TeachStorage(device),
      check,
      readAddress: (text) => readLessonAddress(text, location.host, readShort),
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
