/** The presets come with their pictures in a file of their own; the first screen shows none. */
import { lazyPart } from "../../ui/lazy-part.tsx";

export const LazyPresetsPanel = lazyPart<{ onChosen?: () => void }>(
  async () => (await import("./PresetsPanel.tsx")).PresetsPanel,
);
