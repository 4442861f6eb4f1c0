import { lazyDialog } from "../lazy-part.tsx";

export const PrintDialog = lazyDialog(async () => (await import("./PrintDialog.tsx")).PrintDialog);
