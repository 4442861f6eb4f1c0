/** The Remote panel comes when Remote is chosen; who never drives by script never loads it. */
import { lazyPart } from "../../ui/lazy-part.tsx";

export const LazyRemotePanel = lazyPart(
  async () => (await import("./RemotePanel.tsx")).RemotePanel,
);
