/** Places for the lessons on the first screen: their files come only when a challenge is open. */
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { ChallengeLine, MissionCard } from "./lazy-lessons.ts";
import { LessonsInvitation } from "./LessonsInvitation.tsx";

/** At the top of the panel: the mission, or the invitation to the first one. */
export function MissionPlace({ look = "full" }: { look?: "full" | "slim" }) {
  const { challenge } = useServices();
  const isOpen = useStore(challenge, (state) => state.challenge !== null);
  return isOpen ? <MissionCard look={look} /> : <LessonsInvitation />;
}

/** In the strip above the maze. */
export function ChallengePlace() {
  const { challenge } = useServices();
  const isOpen = useStore(challenge, (state) => state.challenge !== null);
  return isOpen ? <ChallengeLine /> : null;
}
