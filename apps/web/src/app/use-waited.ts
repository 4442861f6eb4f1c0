/** How long a script let its robot wait up to a moment: what the page counts apart from the driving. */
import { useCallback, useSyncExternalStore } from "react";
import { useServices } from "./services.ts";

/** @returns ticks of waiting up to the end of `tick`; they are part of `tick` */
export function useWaited(tick: number): number {
  const { timeline } = useServices();
  const listen = useCallback((listener: () => void) => timeline.listen(listener), [timeline]);
  return useSyncExternalStore(listen, () => timeline.waitedUpTo(tick));
}
