/** The dialog that sends a lesson in a file of its own, with the reader of saved lessons. */
import { lazyDialog } from "../../ui/lazy-part.tsx";

export const SendLesson = lazyDialog(async () => (await import("./SendLesson.tsx")).SendLesson);
