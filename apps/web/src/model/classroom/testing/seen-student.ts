import type { SeenStudent } from "../../../simulator/protocol/classroom-messages.ts";

/** A student who has joined, and done nothing yet. */
export function seenStudent(student: number, change: Partial<SeenStudent> = {}): SeenStudent {
  return {
    student,
    name: { word: null, text: `Team ${student}` },
    helpSince: null,
    programs: 0,
    isConnected: true,
    tile: null,
    busyAt: 0,
    bestAt: 0,
    repeats: 0,
    tasks: [],
    recent: [],
    answers: null,
    ...change,
  };
}
