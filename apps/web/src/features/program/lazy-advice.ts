/** There is no advice before the coach has come, which is after the first screen. */
import { waitingPart } from "../../ui/lazy-part.tsx";

export const LazyAdviceNote = waitingPart(
  async () => (await import("./AdviceNote.tsx")).AdviceNote,
);
export const LazyAdviceNews = waitingPart(
  async () => (await import("./AdviceNews.tsx")).AdviceNews,
);
