/** Robots that follow a wall through a contest maze. */
import { headingNames } from "../maze-limits.ts";
import type { ContestCell } from "./contest-cells.ts";
import type { ContestMaze } from "./contest-maze.ts";
import { neighbourOf, sides, wallsAt } from "./wall-table.ts";

/** The hand that touches the wall. */
export type Hand = "left" | "right";

/**
 * The cells that a wall follower visits before it repeats itself, from the start. In each cell it
 * turns to its hand if it can, otherwise it goes straight on, to the other side, or back.
 */
export function followWall(contest: ContestMaze, hand: Hand): ContestCell[] {
  const turn = hand === "right" ? 1 : 3;
  const path: ContestCell[] = [];
  const seen = new Set<string>();
  let cell = contest.start;
  let heading = headingNames.indexOf(contest.maze.start.heading);
  for (;;) {
    const state = `${cell.x} ${cell.y} ${heading}`;
    if (seen.has(state)) return path;
    seen.add(state);
    path.push(cell);
    const step = [turn, 0, 4 - turn, 2]
      .map((by) => (heading + by) % 4)
      .find((to) => isOpen(contest, cell, to));
    if (step === undefined) return path;
    cell = neighbourAt(contest, cell, step) ?? cell;
    heading = step;
  }
}

function isOpen(contest: ContestMaze, cell: ContestCell, heading: number): boolean {
  const bit = sides[heading]?.bit ?? 0;
  return (wallsAt(contest, cell) & bit) === 0 && neighbourAt(contest, cell, heading) !== null;
}

function neighbourAt(contest: ContestMaze, cell: ContestCell, heading: number): ContestCell | null {
  const side = sides[heading];
  return side === undefined ? null : neighbourOf(contest, cell, side);
}
