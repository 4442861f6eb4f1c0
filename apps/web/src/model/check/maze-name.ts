/** The name of a maze of a task in the language of the page: "Tree 31 of seed 7". */
import type { LessonTask } from "@corridor/challenge";
import type { TFunction } from "i18next";

/**
 * @param t with the namespace "check" loaded
 * @param maze see `mazeOf`
 */
export function mazeName(
  t: TFunction<"check">,
  { mazes, unseen }: Pick<LessonTask, "mazes" | "unseen">,
  maze: number,
): string {
  if (maze < mazes.length || unseen === null) return t("maze.given", { number: maze + 1 });
  return t(`maze.${unseen.kind}`, { number: maze - mazes.length + 1, seed: unseen.seed });
}
