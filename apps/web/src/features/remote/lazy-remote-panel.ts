/** The Remote panel loads when the user chooses Remote. */
import { lazyPart } from "../../ui/lazy-part.tsx";

export const LazyRemotePanel = lazyPart(
  async () => (await import("./RemotePanel.tsx")).RemotePanel,
);
