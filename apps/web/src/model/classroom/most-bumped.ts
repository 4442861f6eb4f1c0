/** Where most robots bump. Pure. */
import type { CountedBump } from "../../simulator/protocol/classroom-messages.ts";

export interface MostBumped {
  /** as in tiles */
  maze: string;
  cells: CountedBump[];
  /** number of bumps in each kind of maze */
  counts: BumpCounts;
}

export interface BumpCounts {
  /** in the maze with most of them */
  most: number;
  /** in the other given mazes */
  given: number;
  /** in the other unseen mazes */
  unseen: number;
}

/** The maze of a task with most bumps, and its cells; the first maze without bumps. */
export function mostBumped(task: number, bumps: readonly CountedBump[]): MostBumped {
  const own = bumps.filter((bump) => bump.task === task);
  const sums = new Map<string, number>();
  for (const { maze, count } of own) sums.set(maze, (sums.get(maze) ?? 0) + count);
  const [most] = [...sums].toSorted(([a, many], [b, other]) => other - many || (a < b ? -1 : 1));
  const maze = most?.[0] ?? "g1";
  const counts: BumpCounts = { most: 0, given: 0, unseen: 0 };
  for (const [name, sum] of sums) {
    counts[name === maze ? "most" : isUnseen(name) ? "unseen" : "given"] += sum;
  }
  return { maze, cells: own.filter((bump) => bump.maze === maze), counts };
}

/** @param maze as in tiles */
export function isUnseen(maze: string): boolean {
  return maze.startsWith("u");
}
