/** Mounts the cards on the stage. Their code is a separate chunk. */
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { lazyPart } from "../../ui/lazy-part.tsx";
import type { StageViewStore } from "../../stage/page/stage-view.ts";

const Cards = lazyPart(async () => (await import("./Cards.tsx")).Cards);

export function RunEventCards({ view }: { view: StageViewStore }) {
  const { cards, challenge } = useServices();
  const isAny = useStore(cards, ({ bump, goal }) => bump !== null || goal !== null);
  const isMet = useStore(challenge, ({ result }) => result.state === "met");
  return isAny || isMet ? <Cards view={view} /> : null;
}
