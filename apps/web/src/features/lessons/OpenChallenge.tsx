/**
 * Slots for the lessons on the first screen. The parts of an open challenge load only when one is
 * open.
 */
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { ChallengeLine, MissionCard } from "./lazy-lessons.ts";
import { LessonsInvitation } from "./LessonsInvitation.tsx";

interface MissionPlaceProps {
  look?: "full" | "slim" | "hint";
  /** whether the invitation to the first mission appears while none is open */
  isInviting?: boolean;
}

/** Top of the panel: the mission, or the invitation to the first one. */
export function MissionPlace({ look = "full", isInviting = look === "full" }: MissionPlaceProps) {
  const { challenge } = useServices();
  const isOpen = useStore(challenge, (state) => state.lesson !== null);
  if (isOpen) return <MissionCard look={look} />;
  return isInviting ? <LessonsInvitation /> : null;
}

/** The task in the strip above the maze. */
export function ChallengePlace() {
  const { challenge } = useServices();
  const isOpen = useStore(challenge, (state) => state.lesson !== null);
  return isOpen ? <ChallengeLine /> : null;
}
