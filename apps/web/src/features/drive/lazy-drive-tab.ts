/** A phone's Drive tab comes when it is opened, or once the page has time. */
import { lazyPart } from "../../ui/lazy-part.tsx";

export const LazyDriveTab = lazyPart(async () => (await import("./DriveTab.tsx")).DriveTab);
