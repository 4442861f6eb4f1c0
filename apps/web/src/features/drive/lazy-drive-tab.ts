/** The Drive tab of a phone loads when it opens, or when the page is idle. */
import { lazyPart } from "../../ui/lazy-part.tsx";

export const LazyDriveTab = lazyPart(async () => (await import("./DriveTab.tsx")).DriveTab);
