/** Parts of an open challenge that load on demand. */
import { lazyPart } from "../../ui/lazy-part.tsx";

export const MissionCard = lazyPart(async () => (await import("./MissionCard.tsx")).MissionCard);
export const ChallengeLine = lazyPart(
  async () => (await import("./ChallengeLine.tsx")).ChallengeLine,
);
