/** Checks a contest maze: whether it can be solved, and the rules of contests that it breaks. */
import { distancesFromStart, UNREACHABLE } from "../flood-fill.ts";
import { isBlock, sizeOf } from "../maze-cells.ts";
import type { Cell } from "../maze-document.ts";
import { cellOf, type ContestCell } from "./contest-cells.ts";
import type { ContestMaze } from "./contest-maze.ts";
import { hasOuterWall, missingPosts } from "./outer-wall.ts";
import { followWall } from "./wall-follower.ts";
import { islandsAround } from "./wall-islands.ts";
import { cellsOf, neighbourOf, sides, wallsAt } from "./wall-table.ts";

/**
 * - `outer-wall`: the outer wall has a gap
 * - `missing-posts`: posts inside of the maze are missing
 * - `unreachable-cells`: no path leads to some cells
 * - `start-walls`: the start has not three walls
 * - `goal-entrances`: the goal has not one entrance
 * - `centre-post`: a wall touches the post in the middle of four goal cells
 * - `bare-posts`: no wall touches some other posts
 * - `wall-follower`: a robot that follows a wall reaches the goal
 */
export const contestRules = [
  "outer-wall",
  "missing-posts",
  "unreachable-cells",
  "start-walls",
  "goal-entrances",
  "centre-post",
  "bare-posts",
  "wall-follower",
] as const;
export type ContestRule = (typeof contestRules)[number];

/** A rule that a maze breaks. */
export interface BrokenRule {
  rule: ContestRule;
  /** number of cells, posts, walls or entrances; null for rules that count nothing */
  count: number | null;
}

/** Why a wall follower does not reach a goal that a path leads to. Cells of the document. */
export interface WallFollowerMiss {
  /** blocks of the walls around the goal, which the outer wall does not touch; may be empty */
  island: Cell[];
  /** the path of a robot that follows the wall on its right, until it repeats itself */
  loop: Cell[];
}

export interface ContestCheck {
  /** contest cells from the start to the nearest goal; null if no path leads to a goal */
  shortestPath: number | null;
  /** whether a robot that follows the wall on its right or left reaches a goal */
  isFollowed: boolean;
  broken: BrokenRule[];
  /** null if a wall follower reaches the goal, or no path does */
  wallFollowerMiss: WallFollowerMiss | null;
}

export function checkContest(contest: ContestMaze): ContestCheck {
  const { maze } = contest;
  const { columns } = sizeOf(maze);
  const distances = distancesFromStart(maze);
  const distanceOf = (cell: ContestCell): number => {
    const { column, row } = cellOf(contest, cell);
    return distances[row * columns + column] ?? UNREACHABLE;
  };
  const reached = contest.goals.map(distanceOf).filter((distance) => distance !== UNREACHABLE);
  const shortestPath = reached.length === 0 ? null : Math.min(...reached) / 2;
  const paths = [followWall(contest, "right"), followWall(contest, "left")] as const;
  const isGoal = goalTest(contest);
  const isFollowed = paths.some((path) => path.some(isGoal));

  const broken: BrokenRule[] = [];
  const count = (rule: ContestRule, found: number, expected = 0): void => {
    if (found !== expected) broken.push({ rule, count: found });
  };
  if (!hasOuterWall(maze)) broken.push({ rule: "outer-wall", count: null });
  count("missing-posts", missingPosts(maze));
  count(
    "unreachable-cells",
    [...cellsOf(contest)].filter((cell) => distanceOf(cell) === UNREACHABLE).length,
  );
  const startWalls = wallsAt(contest, contest.start);
  count("start-walls", sides.filter(({ bit }) => (startWalls & bit) !== 0).length, 3);
  if (contest.goals.length > 0) count("goal-entrances", entrancesOf(contest), 1);
  const { isCentreBare, others } = barePosts(contest);
  if (!isCentreBare) broken.push({ rule: "centre-post", count: null });
  count("bare-posts", others);
  if (isFollowed) broken.push({ rule: "wall-follower", count: null });

  const isMissed = shortestPath !== null && !isFollowed;
  const loop = paths[0].map((cell) => cellOf(contest, cell));
  return {
    shortestPath,
    isFollowed,
    broken,
    wallFollowerMiss: isMissed ? { island: islandsAround(maze), loop } : null,
  };
}

function goalTest({ goals, rows }: ContestMaze): (cell: ContestCell) => boolean {
  const keys = new Set(goals.map(({ x, y }) => x * rows + y));
  return ({ x, y }) => keys.has(x * rows + y);
}

/** Number of openings between a goal and another cell. */
function entrancesOf(contest: ContestMaze): number {
  const isGoal = goalTest(contest);
  let count = 0;
  for (const cell of [...cellsOf(contest)].filter(isGoal)) {
    for (const side of sides) {
      const neighbour = neighbourOf(contest, cell, side);
      if (neighbour === null || isGoal(neighbour)) continue;
      if ((wallsAt(contest, cell) & side.bit) === 0) count += 1;
    }
  }
  return count;
}

/** Posts that no wall touches. The centre is the post between four goals, if they have one. */
function barePosts(contest: ContestMaze): { isCentreBare: boolean; others: number } {
  const { maze } = contest;
  const { columns, rows } = sizeOf(maze);
  const isGoal = goalTest(contest);
  let isCentreBare = true;
  let others = 0;
  for (let row = 2; row < rows - 2; row += 2) {
    for (let column = 2; column < columns - 2; column += 2) {
      if (!isBlock(maze, column, row)) continue;
      const isBare =
        !isBlock(maze, column, row - 1) &&
        !isBlock(maze, column + 1, row) &&
        !isBlock(maze, column, row + 1) &&
        !isBlock(maze, column - 1, row);
      const x = column / 2;
      const y = contest.rows - row / 2;
      const isCentre = [0, 1].every((left) =>
        [0, 1].every((down) => isGoal({ x: x - left, y: y - down })),
      );
      if (isCentre) isCentreBare &&= isBare;
      else if (isBare) others += 1;
    }
  }
  return { isCentreBare, others };
}
