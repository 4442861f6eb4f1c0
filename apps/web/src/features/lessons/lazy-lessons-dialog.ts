/** The path of missions comes when it is asked for. */
import { lazyDialog } from "../../ui/lazy-part.tsx";

export const LessonsDialog = lazyDialog(
  async () => (await import("./LessonsDialog.tsx")).LessonsDialog,
);
