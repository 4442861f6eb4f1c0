/** The command of a script at the displayed tick. */
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { useDisplayedTick } from "../../model/use-displayed-tick.ts";

/**
 * @returns its number at the relay; null while the newest tick is displayed, or if no command runs
 * at the displayed one
 */
export function useSelectedCommand(): number | null {
  const { run } = useServices();
  const isNow = useStore(run, ({ view }) => view === "now");
  const seq = useStore(useDisplayedTick(), ({ command }) => command?.seq ?? null);
  return isNow ? null : seq;
}
