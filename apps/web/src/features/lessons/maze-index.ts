/** Which maze of a challenge is on the screen. */
import type { ChallengeDocument } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";

/** Which maze of a challenge this is, whatever it is called; null when it is none of them. */
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
