import type { ChallengeDocument } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";

/**
 * Index of a maze in its challenge, regardless of the name; null if the challenge does not contain
 * it.
 */
export function mazeIndex({ mazes }: ChallengeDocument, maze: MazeDocument): number | null {
  const at = mazes.findIndex((each) => placesOf(each) === placesOf(maze));
  return at < 0 ? null : at;
}

function placesOf({ blocks, start, goals }: MazeDocument): string {
  return JSON.stringify([
    blocks,
    [start.column, start.row, start.heading],
    goals.map(({ column, row }) => [column, row]),
  ]);
}
