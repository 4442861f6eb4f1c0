/** Texts about contest mazes. The namespace "contest" is loaded. */
import type { BrokenRule, ContestCheck, ContestMaze } from "@corridor/maze";
import type { i18n } from "i18next";
import { joinSentences } from "../../../text/joined.ts";

/** Whether the maze can be solved, its shortest path, and the rules of contests that it breaks. */
export function checkText(
  { t }: Pick<i18n, "t">,
  { columns, rows, goals }: ContestMaze,
  { shortestPath, broken, wallFollowerMiss }: ContestCheck,
): string {
  const noPath = goals.length === 0 ? t("contest:noGoal") : t("contest:noPath");
  const isClean = broken.length === 0 && shortestPath !== null;
  return joinSentences(t, [
    t("contest:size", { columns, rows }),
    shortestPath === null ? noPath : t("contest:path", { cells: shortestPath }),
    ...(wallFollowerMiss === null ? [] : [t("contest:follower")]),
    ...broken.map(({ rule, count }: BrokenRule) => t(`contest:rules.${rule}`, { number: count })),
    ...(isClean ? [t("contest:allRules")] : []),
  ]);
}
