/** What the card of a student shows. */
import { openTask, openWork } from "../../model/classroom/standing.ts";
import { timeOf, verificationOf, type DashboardState } from "../../model/classroom/dashboard.ts";
import type { SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import type { CardState } from "./StandingChip.tsx";

/** @param student one of the state */
export function cardState(state: DashboardState, student: SeenStudent): CardState {
  const standing = state.shown.get(student.student)?.standing ?? "working";
  const verification = verificationOf(state, student)?.kind;
  const isOpen = standing === "working" || standing === "bumped";
  if (isOpen && verification === "fails") return "unverified";
  if (standing !== "working") return standing;
  if (verification === "checking") return "checking";
  return student.tile?.state === "driving" ? "driving" : "writing";
}

function writtenLines({ programs }: DashboardState, student: SeenStudent): number | null {
  const read = programs.get(student.student);
  return read?.task === openTask(student) ? (read.program?.rules.length ?? null) : null;
}

export interface CardNumbers {
  /** whole seconds on the open task */
  seconds: number;
  /** of the verified solution, or of the newest program; null: not known */
  lines: number | null;
  attempts: number;
}

export function cardNumbers(state: DashboardState, student: SeenStudent): CardNumbers {
  const verification = verificationOf(state, student);
  return {
    seconds: Math.floor(timeOf(state, student) / 1_000),
    lines:
      verification?.kind === "passes" ? verification.claim.lines : writtenLines(state, student),
    attempts: openWork(student)?.attempts ?? 0,
  };
}
