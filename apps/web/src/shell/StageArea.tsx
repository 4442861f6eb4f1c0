/** The stage, with the parts that other features add. */
import { RunEventCards } from "../features/cards/RunEventCards.tsx";
import { ChallengePlace } from "../features/lessons/OpenChallenge.tsx";
import { HistoryButtons } from "../features/maze-editor/HistoryButtons.tsx";
import { Stage } from "../features/maze-editor/Stage.tsx";
import { WallMarksPlace } from "../features/files/WallMarksPlace.tsx";
import { RacePlace } from "../features/race/RacePlace.tsx";
import { deferredPart, lazyPart } from "../ui/lazy-part.tsx";

const StageCards = deferredPart(async () => (await import("./StageCards.tsx")).StageCards);
const SoundMenu = lazyPart(async () => (await import("../features/sound/SoundMenu.tsx")).SoundMenu);

export function StageArea() {
  return (
    <Stage
      history={<HistoryButtons />}
      strip={
        <>
          <ChallengePlace />
          <RacePlace />
        </>
      }
      sound={<SoundMenu />}
      cards={(view) => (
        <>
          <WallMarksPlace view={view} />
          <RunEventCards>
            <StageCards isWanted view={view} />
          </RunEventCards>
        </>
      )}
    />
  );
}
