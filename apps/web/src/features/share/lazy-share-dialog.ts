/** The share dialog, in a file of its own, for all that open it. */
import { lazyDialog } from "../../ui/lazy-part.tsx";

export const ShareDialog = lazyDialog(async () => (await import("./ShareDialog.tsx")).ShareDialog);
