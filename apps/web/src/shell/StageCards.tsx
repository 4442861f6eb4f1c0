import { Cards } from "../features/cards/Cards.tsx";
import { RaceButton } from "../features/race/RaceButton.tsx";
import { RaceOutcome } from "../features/race/RaceOutcome.tsx";
import type { StageViewStore } from "../stage/page/stage-view.ts";
import { deferredPart } from "../ui/lazy-part.tsx";

const TaskSentence = deferredPart(
  async () => (await import("../features/lessons/TaskSentence.tsx")).TaskSentence,
);

/** The cards on the stage. Their code is a separate chunk. */
export function StageCards({ view }: { view: StageViewStore }) {
  return (
    <Cards
      view={view}
      task={<TaskSentence isWanted />}
      raceOutcome={<RaceOutcome />}
      raceButton={<RaceButton kind="quiet" />}
    />
  );
}
