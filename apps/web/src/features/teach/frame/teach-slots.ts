/**
 * Parts of the student's page inside the pages for teachers. The page above provides them, because
 * features do not import each other.
 */
import type { LessonDocument, LessonTask } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { ComponentType, ReactNode } from "react";
import type { Solution } from "../../../model/teaching/solution.ts";

export interface WorkbenchProps {
  /** the displayed maze */
  maze: MazeDocument;
  /** the lines that the task starts with */
  program: ProgramDocument;
  /** receives each finished edit of the maze */
  onMaze: (maze: MazeDocument) => void;
  /** receives each edit of the lines */
  onProgram: (program: ProgramDocument) => void;
  /** places the stage and the editor of the lines */
  children: (parts: WorkbenchParts) => ReactNode;
}

export interface WorkbenchParts {
  stage: ReactNode;
  lines: ReactNode;
}

export interface TrialProps {
  lesson: LessonDocument;
  /** opens in the first task; null for the lines that the task starts with */
  program: ProgramDocument | null;
  /** called when an attempt passes a task in all its mazes */
  onSolved: (task: LessonTask, solution: Solution) => void;
  /** above the student's page */
  band: ReactNode;
}

export interface TeachSlots {
  /** the student's stage and editor of lines, for the documents of a task */
  Workbench: ComponentType<WorkbenchProps>;
  /** the student's page with a lesson */
  Trial: ComponentType<TrialProps>;
}
