/**
 * The presets and their pictures are a separate chunk, because the first screen does not show them.
 */
import { lazyPart } from "../../ui/lazy-part.tsx";

export const LazyPresetsPanel = lazyPart<{ onChosen?: () => void }>(
  async () => (await import("./PresetsPanel.tsx")).PresetsPanel,
);
