/** The name of a maze of a race in the language of the page: "Tree 31 of seed 7". */
import type { LessonDocument } from "@corridor/challenge";
import { useTranslation } from "react-i18next";
import { mazeName } from "../../model/check/maze-name.ts";

/** @returns names a maze of the task, as in tiles */
export function useRaceMazeName(lesson: LessonDocument, task: number): (maze: string) => string {
  const { t } = useTranslation("check", { useSuspense: false });
  const document = lesson.tasks[task - 1];
  return (maze) => {
    if (document === undefined) return "";
    const first = maze.startsWith("u") ? document.mazes.length : 0;
    return mazeName(t, document, first + Number(maze.slice(1)) - 1);
  };
}
