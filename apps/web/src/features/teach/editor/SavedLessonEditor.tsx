/** Opens a lesson of this device in the editor, and saves its edits. */
import { useEffect, useState, type ReactNode, type RefObject } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { LessonAutosave } from "./lesson-autosave.ts";
import { SavedLessons, type SavedLesson } from "../../../model/teaching/saved-lessons.ts";
import { SharedLessons } from "../../../model/teaching/shared-lessons.ts";
import { TeachFrame } from "../frame/TeachFrame.tsx";
import type { TeachSlots } from "../frame/teach-slots.ts";
import { lessonHash } from "../frame/teach-view.ts";
import { DraftProvider } from "./draft-context.ts";
import { LessonDraft } from "./lesson-draft.ts";
import { LessonEditor } from "./LessonEditor.tsx";

interface SavedLessonEditorProps {
  /** of the saved lesson */
  id: string;
  /** localStorage */
  device: KeyValueStorage;
  /** the buttons for theme and language */
  tools: ReactNode;
  slots: TeachSlots;
  main: RefObject<HTMLElement | null>;
}

export function SavedLessonEditor({ id, device, ...frame }: SavedLessonEditorProps) {
  const { t } = useTranslation(["lessonEditor", "teach"], { useSuspense: false });
  const [lessons] = useState(() => new SavedLessons(device));
  const [saved] = useState(() => lessons.read(id));
  if (saved === null) {
    return (
      <TeachFrame title={t("teach:title")} end={frame.tools} main={frame.main}>
        <p>{t("lessonEditor:missing")}</p>
        <p>
          <a href="/teach">{t("lessonEditor:menu.all")}</a>
        </p>
      </TeachFrame>
    );
  }
  return <OpenLessonEditor lessons={lessons} saved={saved} device={device} {...frame} />;
}

interface OpenLessonEditorProps extends Pick<
  SavedLessonEditorProps,
  "device" | "tools" | "slots" | "main"
> {
  lessons: SavedLessons;
  saved: SavedLesson;
}

function OpenLessonEditor({ lessons, saved, ...frame }: OpenLessonEditorProps) {
  const [{ draft, autosave }] = useState(() => {
    const shared = new SharedLessons(frame.device);
    const opened = new LessonDraft(saved.lesson, saved.solutions, (lesson) => shared.has(lesson));
    const later = (run: () => void, milliseconds: number) => setTimeout(run, milliseconds);
    const ports = { lessons, draft: opened, now: () => Date.now(), later };
    return { draft: opened, autosave: new LessonAutosave(ports, saved) };
  });
  useSaving(autosave);
  return (
    <DraftProvider value={draft}>
      <LessonEditor draft={draft} autosave={autosave} {...frame} />
    </DraftProvider>
  );
}

/** Saves when the page is hidden or left, and asks before edits are lost that cannot be saved. */
function useSaving(autosave: LessonAutosave): void {
  const id = useStore(autosave.store, (state) => state.id);
  const isBlocked = useStore(autosave.store, (state) => state.status === "blocked");
  useEffect(() => {
    autosave.start();
    const flush = () => autosave.flush();
    window.addEventListener("pagehide", flush);
    document.addEventListener("visibilitychange", flush);
    return () => {
      window.removeEventListener("pagehide", flush);
      document.removeEventListener("visibilitychange", flush);
      autosave.end();
    };
  }, [autosave]);
  useEffect(() => {
    // A copy has an address of its own.
    if (location.hash !== lessonHash(id)) history.replaceState(null, "", lessonHash(id));
  }, [id]);
  useEffect(() => {
    if (!isBlocked) return;
    const ask = (event: Event): void => event.preventDefault();
    window.addEventListener("beforeunload", ask);
    return () => window.removeEventListener("beforeunload", ask);
  }, [isBlocked]);
}
