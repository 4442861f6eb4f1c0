/**
 * Slot in the strip above the maze: the current race, or a button to race the past run on display.
 */
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { deferredPart } from "../../ui/lazy-part.tsx";

const RaceChip = deferredPart(async () => (await import("./RaceChip.tsx")).RaceChip);
const RaceIconButton = deferredPart(
  async () => (await import("./RaceIconButton.tsx")).RaceIconButton,
);

export function RacePlace() {
  const { race, run } = useServices();
  const isOn = useStore(race, ({ ghosts }) => ghosts.length > 0);
  const isPast = useStore(run, ({ view }) => view !== "now");
  if (isOn) return <RaceChip isWanted />;
  return isPast ? <RaceIconButton isWanted /> : null;
}
