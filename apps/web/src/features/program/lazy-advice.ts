/** There is no advice before the coach has come, which is after the first screen. */
import { deferredPart } from "../../ui/lazy-part.tsx";

const loadNote = async () => (await import("./AdviceNote.tsx")).AdviceNote;

export const LazyAdviceNote = deferredPart(loadNote);

/** Comes after the note, which it brings into sight. */
export const LazyAdviceNews = deferredPart(async () => {
  const [{ AdviceNews }] = await Promise.all([import("./AdviceNews.tsx"), loadNote()]);
  return AdviceNews;
});
