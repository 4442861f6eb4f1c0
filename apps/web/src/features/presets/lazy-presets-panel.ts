/**
 * The presets and their pictures are a separate chunk, because the first screen does not show them.
 */
import { lazyPart } from "../../ui/lazy-part.tsx";
import type { PresetsPanelProps } from "./PresetsPanel.tsx";

export const LazyPresetsPanel = lazyPart<PresetsPanelProps>(
  async () => (await import("./PresetsPanel.tsx")).PresetsPanel,
);
