import type { ChallengeDocument } from "@corridor/challenge";
import { isSameLayout, type MazeDocument } from "@corridor/maze";

/**
 * Index of a maze in its challenge, regardless of the name; null if the challenge does not contain
 * it.
 */
export function mazeIndex({ mazes }: ChallengeDocument, maze: MazeDocument): number | null {
  const at = mazes.findIndex((each) => isSameLayout(each, maze));
  return at < 0 ? null : at;
}
