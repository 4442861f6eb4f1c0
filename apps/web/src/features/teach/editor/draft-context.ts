/** Gives the components of the editor access to the open lesson. */
import type { LessonDocument, LessonTask } from "@corridor/challenge";
import { createContext, useContext } from "react";
import { useStore } from "zustand";
import { openTaskOf, type LessonDraft } from "./lesson-draft.ts";

const DraftContext = createContext<LessonDraft | null>(null);
export const DraftProvider = DraftContext.Provider;

export function useDraft(): LessonDraft {
  const draft = useContext(DraftContext);
  if (draft === null) throw new Error("useDraft needs a DraftProvider above it");
  return draft;
}

export function useLesson(): LessonDocument {
  return useStore(useDraft().store, (state) => state.lesson);
}

/** The open task. */
export function useOpenTask(): LessonTask {
  return useStore(useDraft().store, openTaskOf);
}
