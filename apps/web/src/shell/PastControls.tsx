import { RaceButton } from "../features/race/RaceButton.tsx";
import { PastBar } from "../features/timeline/PastBar.tsx";

/** The controls of the past. Their code is a separate chunk. */
export function PastControls() {
  return <PastBar race={<RaceButton size="small" />} />;
}
