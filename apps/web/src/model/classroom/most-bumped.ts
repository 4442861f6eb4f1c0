/** Where most robots bump. Pure. */
import type { CountedBump } from "../../simulator/protocol/classroom-messages.ts";

/** The maze of a task with most bumps, and its cells; the first maze without bumps. */
export function mostBumped(
  task: number,
  bumps: readonly CountedBump[],
): { maze: string; cells: CountedBump[] } {
  const own = bumps.filter((bump) => bump.task === task);
  const sums = new Map<string, number>();
  for (const { maze, count } of own) sums.set(maze, (sums.get(maze) ?? 0) + count);
  const [most] = [...sums].toSorted(([a, many], [b, other]) => other - many || (a < b ? -1 : 1));
  const maze = most?.[0] ?? "g1";
  return { maze, cells: own.filter((bump) => bump.maze === maze) };
}
