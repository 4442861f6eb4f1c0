/** The dialog that adds a task in a file of its own, with the missions. */
import { lazyDialog } from "../../../ui/lazy-part.tsx";

export const AddTaskDialog = lazyDialog(
  async () => (await import("./AddTaskDialog.tsx")).AddTaskDialog,
);
