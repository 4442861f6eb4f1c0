/** Loads the path of missions on demand. */
import { lazyDialog } from "../../ui/lazy-part.tsx";

export const LessonsDialog = lazyDialog(
  async () => (await import("./LessonsDialog.tsx")).LessonsDialog,
);
