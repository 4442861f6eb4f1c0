/** The share dialog of a lesson in a file of its own, with the package for QR codes. */
import { lazyDialog } from "../../../ui/lazy-part.tsx";

export const ShareLessonDialog = lazyDialog(
  async () => (await import("./ShareLessonDialog.tsx")).ShareLessonDialog,
);
