/** Reads the file, the link or the text with which a teacher begins a lesson or a task. */
import type { LessonDocument } from "@corridor/challenge";
import { useState } from "react";
import type { TextFile } from "../../../ui/incoming-files.ts";
import type { LessonProblem } from "../lessons/read-lesson.ts";
import { readBeginning, readBeginningFile, type BeginningResult } from "./read-beginning.ts";

export interface Beginning {
  /** why nothing was opened */
  problem: LessonProblem | null;
  isOpening: boolean;
  openText: (text: string) => Promise<void>;
  openFiles: (files: readonly TextFile[]) => Promise<void>;
}

/**
 * @param task name of the task in a shared maze
 * @param onOpened receives the lesson, and whether it was shared as it is, not made of a maze
 */
export function useBeginning(
  task: string,
  onOpened: (lesson: LessonDocument, isShared: boolean) => void,
): Beginning {
  const [problem, setProblem] = useState<LessonProblem | null>(null);
  const [isOpening, setOpening] = useState(false);

  function receive({ opened, isShared }: BeginningResult): void {
    setOpening(false);
    setProblem(opened.ok ? null : { code: opened.code, problems: opened.problems });
    if (opened.ok) onOpened(opened.lesson, isShared);
  }

  return {
    problem,
    isOpening,
    openText: async (text) => {
      setOpening(true);
      receive(await readBeginning(text, task));
    },
    openFiles: async ([file]) => {
      if (file !== undefined) receive(await readBeginningFile(file, task));
    },
  };
}
