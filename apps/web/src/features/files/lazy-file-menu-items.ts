/** The file part of a menu, for menus that are part of the first screen. */
import { lazyPart } from "../../ui/lazy-part.tsx";

export const LazyFileMenuItems = lazyPart(
  async () => (await import("./FileMenuItems.tsx")).FileMenuItems,
);
