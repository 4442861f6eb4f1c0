/** Edits of a lesson's tasks, its survey and the mazes of a task. */
import type { LessonDocument, LessonTask } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";

/** The tasks of a lesson with one id for each, so that a task keeps its identity when it moves. */
export interface TaskList {
  lesson: LessonDocument;
  taskIds: readonly number[];
}

let lastTaskId = 0;
export function newTaskIds(count: number): number[] {
  return Array.from({ length: count }, () => ++lastTaskId);
}

export function replaceTask({ lesson, taskIds }: TaskList, at: number, task: LessonTask): TaskList {
  return { lesson: { ...lesson, tasks: lesson.tasks.with(at, task) }, taskIds };
}

export function insertTasks(
  { lesson, taskIds }: TaskList,
  at: number,
  tasks: readonly LessonTask[],
): TaskList {
  return {
    lesson: { ...lesson, tasks: lesson.tasks.toSpliced(at, 0, ...tasks) },
    taskIds: taskIds.toSpliced(at, 0, ...newTaskIds(tasks.length)),
  };
}

export function removeTask({ lesson, taskIds }: TaskList, at: number): TaskList {
  return {
    lesson: { ...lesson, tasks: lesson.tasks.toSpliced(at, 1) },
    taskIds: taskIds.toSpliced(at, 1),
  };
}

export function moveTask({ lesson, taskIds }: TaskList, from: number, to: number): TaskList {
  return {
    lesson: { ...lesson, tasks: moved(lesson.tasks, from, to) },
    taskIds: moved(taskIds, from, to),
  };
}

function moved<Item>(list: readonly Item[], from: number, to: number): Item[] {
  const item = list.slice(from, from + 1);
  return list.toSpliced(from, 1).toSpliced(to, 0, ...item);
}

export function insertMaze(task: LessonTask, at: number, maze: MazeDocument): LessonTask {
  return { ...task, mazes: task.mazes.toSpliced(at, 0, maze) };
}

export function removeMaze(task: LessonTask, at: number): LessonTask {
  return { ...task, mazes: task.mazes.toSpliced(at, 1) };
}

/**
 * Adds a question. Its id is the column of its answers: it never changes, and the id of a deleted
 * question is used again only for the last one.
 */
export function addQuestion(lesson: LessonDocument, question: string): LessonDocument {
  const numbers = lesson.survey.map(({ id }) => Number(/^question_(\d+)$/.exec(id)?.[1] ?? 0));
  const id = `question_${Math.max(0, ...numbers) + 1}`;
  return { ...lesson, survey: [...lesson.survey, { id, question }] };
}
