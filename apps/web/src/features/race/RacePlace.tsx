/** In the strip above the maze: the race that is on, or the way to race the run that is looked back at. */
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { lazyPart } from "../../ui/lazy-part.tsx";

const RaceChip = lazyPart(async () => (await import("./RaceChip.tsx")).RaceChip);
const RaceIconButton = lazyPart(async () => (await import("./RaceIconButton.tsx")).RaceIconButton);

export function RacePlace() {
  const { race, run } = useServices();
  const isOn = useStore(race, ({ ghosts }) => ghosts.length > 0);
  const isPast = useStore(run, ({ view }) => view !== "now");
  if (isOn) return <RaceChip />;
  return isPast ? <RaceIconButton /> : null;
}
