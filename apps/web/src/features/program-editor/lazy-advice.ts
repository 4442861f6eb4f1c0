/** Advice parts. There is no advice until the coach loads after the first screen. */
import { deferredPart } from "../../ui/lazy-part.tsx";

export const LazyAdviceNote = deferredPart(
  async () => (await import("./AdviceNote.tsx")).AdviceNote,
);

export const LazyAdviceAnnouncement = deferredPart(
  async () => (await import("./AdviceAnnouncement.tsx")).AdviceAnnouncement,
);
