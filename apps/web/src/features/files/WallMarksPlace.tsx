/** The place of the marks over the maze. Their code loads when they are first shown. */
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import { deferredPart } from "../../ui/lazy-part.tsx";

const WallMarks = deferredPart(async () => (await import("./contest/WallMarks.tsx")).WallMarks);

export function WallMarksPlace({ view }: { view: StageViewStore }) {
  const { screen } = useServices();
  return <WallMarks view={view} isWanted={useStore(screen, ({ wallMarks }) => !!wallMarks)} />;
}
