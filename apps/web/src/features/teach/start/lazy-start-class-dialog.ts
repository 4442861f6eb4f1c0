/** The dialog that starts a class in a file of its own. */
import { lazyDialog } from "../../../ui/lazy-part.tsx";

export const StartClassDialog = lazyDialog(
  async () => (await import("./StartClassDialog.tsx")).StartClassDialog,
);
