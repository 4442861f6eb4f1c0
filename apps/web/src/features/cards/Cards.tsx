/** The card that belongs to the moment on the screen: why the robot bumped, or that the maze is solved. */
import { useState } from "react";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import type { Explanation } from "../../stores/card-store.ts";
import type { StageViewStore } from "../stage/stage-view.ts";
import { BumpCard } from "./BumpCard.tsx";
import { shownCard } from "./shown-card.ts";
import { SolvedCard } from "./SolvedCard.tsx";

export function Cards({ view }: { view: StageViewStore }) {
  const { run, cards } = useServices();
  const { bump, goal } = useStore(cards);
  const kind = useStore(run, ({ snapshot, view: shown }) =>
    shownCard({ bump, goal }, snapshot, shown),
  );
  const [closed, setClosed] = useState<Explanation | null>(null);
  const explanation = kind === null ? null : kind === "bump" ? bump : goal;
  if (explanation === null || explanation === closed) return null;
  const close = () => setClosed(explanation);
  return kind === "bump" ? (
    <BumpCard key={explanation.moment.tick} view={view} explanation={explanation} onClose={close} />
  ) : (
    <SolvedCard view={view} explanation={explanation} onClose={close} />
  );
}
