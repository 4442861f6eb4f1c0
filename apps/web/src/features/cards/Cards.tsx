/** The card that belongs to the moment on the screen: why the robot bumped, or that the maze is solved. */
import { useEffect, useState } from "react";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import type { Explanation } from "../../stores/card-store.ts";
import type { StageViewStore } from "../stage/stage-view.ts";
import { BumpCard } from "./BumpCard.tsx";
import { shownCard } from "./shown-card.ts";
import { SolvedCard } from "./SolvedCard.tsx";

export function Cards({ view }: { view: StageViewStore }) {
  const { run, cards, workspace } = useServices();
  const { bump, goal } = useStore(cards);
  const kind = useStore(run, ({ snapshot, view: shown }) =>
    shownCard({ bump, goal }, snapshot, shown),
  );
  const [closed, setClosed] = useState<Explanation | null>(null);
  const found = kind === null ? null : kind === "bump" ? bump : goal;
  // What another program took says nothing of the one that stands there now.
  const isPrograms = useStore(workspace, ({ program }) => found?.program === program);
  const isStale = kind === "goal" && !isPrograms;
  const explanation = found === closed || isStale ? null : found;
  useEffect(() => {
    if (explanation === null) return undefined;
    // From anywhere on the page, as Escape closes everything else; what lies on top has it first.
    const onKey = (event: KeyboardEvent) => {
      const isCovered = document.querySelector("dialog:modal, :popover-open") !== null;
      if (event.key === "Escape" && !isCovered) setClosed(explanation);
    };
    window.addEventListener("keydown", onKey);
    return () => window.removeEventListener("keydown", onKey);
  }, [explanation]);
  if (explanation === null) return null;
  const close = () => setClosed(explanation);
  return kind === "bump" ? (
    <BumpCard key={explanation.moment.tick} view={view} explanation={explanation} onClose={close} />
  ) : (
    <SolvedCard view={view} explanation={explanation} onClose={close} />
  );
}
