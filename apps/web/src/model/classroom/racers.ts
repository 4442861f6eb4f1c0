/** The programs that can race: those that the teacher's page has verified. Pure. */
import { isProgram } from "@corridor/challenge";
import { MAX_RACERS, type Racer } from "@corridor/protocol";
import type { Verifications } from "./verifier.ts";

/** Characters of all codes: a message to the big screens has at most 64 KiB. */
const MAX_CODES = 32_768;

/**
 * The programs that solve a task, without names. Students with the same program share a robot. Most
 * frequent programs come first; those beyond the limits do not race.
 */
export function racersOf(task: number, verifications: Verifications): Racer[] {
  const counts = new Map<string, number>();
  for (const tasks of verifications.values()) {
    const found = tasks.get(task);
    if (found?.kind !== "passes" || !isProgram(found.attempt)) continue;
    const { code } = found.claim;
    counts.set(code, (counts.get(code) ?? 0) + 1);
  }
  const racers: Racer[] = [];
  let left = MAX_CODES;
  // The order of the codes contains nothing about students.
  const sorted = [...counts].toSorted(([a, many], [b, other]) => other - many || (a < b ? -1 : 1));
  for (const [code, count] of sorted) {
    if (racers.length === MAX_RACERS || code.length > left) continue;
    left -= code.length;
    racers.push({ code, count });
  }
  return racers;
}

/** Number of students whose programs race. */
export function countRacers(racers: readonly Pick<Racer, "count">[]): number {
  return racers.reduce((sum, { count }) => sum + count, 0);
}
