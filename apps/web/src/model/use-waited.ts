/** How long a script made its robot wait, which the page counts separately from driving. */
import { useCallback, useSyncExternalStore } from "react";
import { useServices } from "./use-services.ts";

/** @returns ticks of waiting up to the end of `tick`; they are part of `tick` */
export function useWaited(tick: number): number {
  const { timeline } = useServices();
  const listen = useCallback((listener: () => void) => timeline.listen(listener), [timeline]);
  return useSyncExternalStore(listen, () => timeline.waitedUpTo(tick));
}
