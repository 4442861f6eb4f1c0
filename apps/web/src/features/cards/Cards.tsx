/** The card for the displayed tick: why the robot bumped, or that the maze is solved. */
import { useEffect, useState, type ReactNode } from "react";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import type { Explanation } from "../../model/run/card-store.ts";
import {
  challengeResult,
  isJudgedByRun,
  openTask,
  type ChallengeResult,
} from "../../model/challenge/challenge-store.ts";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import { BumpCard } from "./BumpCard.tsx";
import { shownCard } from "./shown-card.ts";
import { SolvedCard, type Solved, type SolvedRace } from "./SolvedCard.tsx";

type Met = Extract<ChallengeResult, { state: "met" }>;

interface CardsProps extends SolvedRace {
  view: StageViewStore;
  /** the sentence of the open task, if there is one */
  task: ReactNode;
}

export function Cards({ view, task, ...race }: CardsProps) {
  const { run, cards, workspace, challenge } = useServices();
  const { bump, goal } = useStore(cards);
  const result = useStore(challenge, challengeResult);
  const isSeen = useStore(challenge, (state) => {
    const task = openTask(state);
    return task !== null && isJudgedByRun(task);
  });
  const kind = useStore(run, ({ snapshot, view: shown }) =>
    shownCard({ bump, goal }, snapshot, shown, result && { result, isSeen }),
  );
  const pose = useStore(run, ({ snapshot }) => (kind === "met" ? snapshot?.pose : undefined));
  const [closed, setClosed] = useState<Explanation | Met | null>(null);
  const found = kind === "bump" ? bump : kind === "goal" ? goal : null;
  // The figures of another program do not describe the program that is open now.
  const isPrograms = useStore(workspace, ({ program }) => found?.program === program);
  const isStale = kind === "goal" && !isPrograms;
  const met = kind === "met" && result?.state === "met" ? result : null;
  const current = isStale ? null : (met ?? found);
  const open = current === closed ? null : current;
  useEffect(() => {
    if (open === null) return undefined;
    // Escape works from anywhere on the page, but a dialog or popover on top receives it first.
    const onKey = (event: KeyboardEvent) => {
      const isCovered = document.querySelector("dialog:modal, :popover-open") !== null;
      if (event.key === "Escape" && !isCovered) setClosed(open);
    };
    window.addEventListener("keydown", onKey);
    return () => window.removeEventListener("keydown", onKey);
  }, [open]);
  if (open === null) return null;
  const close = () => setClosed(open);
  if (kind === "bump" && "event" in open) {
    return (
      <BumpCard key={open.event.tick} view={view} explanation={open} task={task} onClose={close} />
    );
  }
  const solved: Solved | null =
    "event" in open
      ? { ...open.event, ticks: open.event.tick }
      : pose === undefined
        ? null
        : { ...open, pose };
  return solved && <SolvedCard {...race} view={view} solved={solved} onClose={close} />;
}
