/** The parts of the lessons that come when they are needed. */
import { lazyDialog, lazyPart } from "../../ui/lazy-part.tsx";

export const LessonsDialog = lazyDialog(
  async () => (await import("./LessonsDialog.tsx")).LessonsDialog,
);
export const MissionCard = lazyPart(async () => (await import("./MissionCard.tsx")).MissionCard);
export const ChallengeLine = lazyPart(
  async () => (await import("./ChallengeLine.tsx")).ChallengeLine,
);
