/** How many robots bumped in which mazes of a task. Nothing if it has only one maze. */
import type { LessonTask } from "@corridor/challenge";
import { useTranslation } from "react-i18next";
import { isUnseen, type BumpCounts } from "../../model/classroom/most-bumped.ts";

interface BumpPlacesProps {
  task: LessonTask;
  /** with most bumps, as in tiles */
  maze: string;
  counts: BumpCounts;
}

export function BumpPlaces({ task, maze, counts }: BumpPlacesProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  if (task.mazes.length + (task.unseen?.count ?? 0) < 2) return null;
  const number = Number(maze.slice(1));
  return (
    <>
      {t(isUnseen(maze) ? "bumps.inUnseen" : "bumps.inGiven", { number, bumps: counts.most })}
      {counts.given > 0 && `, ${t("bumps.given", { bumps: counts.given })}`}
      {counts.unseen > 0 && `, ${t("bumps.unseen", { bumps: counts.unseen })}`}
    </>
  );
}
