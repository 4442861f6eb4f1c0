/** The program of a run in a file of its own, with the reader of links. */
import { lazyPart } from "../../ui/lazy-part.tsx";

export const LazyScreenProgram = lazyPart(
  async () => (await import("./ScreenProgram.tsx")).ScreenProgram,
);
