/** Advice parts. There is no advice until the coach loads after the first screen. */
import { deferredPart } from "../../ui/lazy-part.tsx";

const loadNote = async () => (await import("./AdviceNote.tsx")).AdviceNote;

export const LazyAdviceNote = deferredPart(loadNote);

/** Resolves after the note, which it scrolls into view. */
export const LazyAdviceAnnouncement = deferredPart(async () => {
  const [{ AdviceAnnouncement }] = await Promise.all([
    import("./AdviceAnnouncement.tsx"),
    loadNote(),
  ]);
  return AdviceAnnouncement;
});
