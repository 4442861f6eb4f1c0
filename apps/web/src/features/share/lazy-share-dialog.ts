/** The share dialog in a file of its own. */
import { lazyDialog } from "../../ui/lazy-part.tsx";

export const ShareDialog = lazyDialog(async () => (await import("./ShareDialog.tsx")).ShareDialog);
