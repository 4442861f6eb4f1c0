/**
 * The lesson that the teacher edits: the document, which task and maze are open, and one history of
 * all edits. Undo also opens the task of the edit that it reverts.
 */
import {
  MAX_CHALLENGE_MAZES,
  MAX_TASKS,
  type LessonDocument,
  type LessonTask,
} from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import { createStore, type StoreApi } from "zustand/vanilla";
import { withoutBlankTexts } from "../../../model/teaching/blank-texts.ts";
import {
  contentMark,
  withSolution,
  type Solution,
  type Solutions,
} from "../../../model/teaching/solution.ts";
import { displayedSeconds } from "../../../text/numbers.ts";
import {
  insertMaze,
  insertTasks,
  moveTask,
  newTaskIds,
  removeMaze,
  removeTask,
  replaceTask,
  type TaskList,
} from "./task-list-edits.ts";

/** What an undo restores. */
interface Version extends TaskList {
  /** index of the open task */
  task: number;
  /** index of the open maze in it */
  maze: number;
}

export interface DraftState extends Version {
  solutions: Solutions;
  past: readonly Version[];
  future: readonly Version[];
}

/** Maximum number of undo steps. */
const MAX_STEPS = 200;

export class LessonDraft {
  readonly store: StoreApi<DraftState>;
  /** edits with the same name form one step of the history, until the field is left */
  #group: string | null = null;
  readonly #isShared: (lesson: LessonDocument) => boolean;

  /** @param isShared whether students may have a lesson */
  constructor(
    lesson: LessonDocument,
    solutions: Solutions = new Map(),
    isShared: (lesson: LessonDocument) => boolean = () => false,
  ) {
    this.#isShared = isShared;
    const taskIds = newTaskIds(lesson.tasks.length);
    const version = { lesson, taskIds, task: 0, maze: 0 };
    this.store = createStore<DraftState>()(() => ({
      ...version,
      solutions,
      past: [],
      future: [],
    }));
  }

  get lesson(): LessonDocument {
    return this.store.getState().lesson;
  }

  /** The open task. A lesson has at least one. */
  get task(): LessonTask {
    return openTaskOf(this.store.getState());
  }

  openTask(task: number): void {
    this.endGroup();
    if (this.lesson.tasks[task] !== undefined) this.store.setState({ task, maze: 0 });
  }

  openMaze(maze: number): void {
    if (this.task.mazes[maze] !== undefined) this.store.setState({ maze });
  }

  /** Changes fields of the lesson. @param group see `#group` */
  edit(change: Partial<LessonDocument>, group: string | null = null): void {
    const { taskIds } = this.store.getState();
    this.#commit({ lesson: { ...this.lesson, ...change }, taskIds }, {}, group);
  }

  /** Replaces the open task. @param group see `#group` */
  setTask(task: LessonTask, group: string | null = null): void {
    const state = this.store.getState();
    this.#commit(replaceTask(state, state.task, task), {}, group);
  }

  /** Changes fields of the open task. @param group see `#group` */
  editTask(change: Partial<LessonTask>, group: string | null = null): void {
    this.setTask({ ...this.task, ...change }, group);
  }

  /** Ends the step of the history to which the typed edits belong. */
  endGroup(): void {
    this.#group = null;
  }

  /** Adds tasks after the open one, and opens the first. @returns whether all fit; else none is added */
  addTasks(tasks: readonly LessonTask[]): boolean {
    const state = this.store.getState();
    if (state.lesson.tasks.length + tasks.length > MAX_TASKS) return false;
    const at = state.task + 1;
    this.#commit(insertTasks(state, at, tasks), { task: at, maze: 0 });
    return true;
  }

  /** Deletes a task; the only task stays. */
  removeTask(at: number): void {
    const state = this.store.getState();
    const { length } = state.lesson.tasks;
    if (length < 2) return;
    const next = state.task > at ? state.task - 1 : Math.min(state.task, length - 2);
    const maze = state.task === at ? 0 : state.maze;
    this.#commit(removeTask(state, at), { task: next, maze });
  }

  /** Moves the open task by one place. */
  moveTask(by: 1 | -1): void {
    const state = this.store.getState();
    const to = state.task + by;
    if (state.lesson.tasks[to] === undefined) return;
    this.#commit(moveTask(state, state.task, to), { task: to });
  }

  /** Replaces the open maze; its name stays. */
  setMaze(maze: MazeDocument): void {
    const { maze: at } = this.store.getState();
    this.editTask({ mazes: this.task.mazes.with(at, maze) });
  }

  /** Adds a maze after the open one, and opens it. */
  addMaze(maze: MazeDocument): void {
    const state = this.store.getState();
    if (this.task.mazes.length >= MAX_CHALLENGE_MAZES) return;
    const at = state.maze + 1;
    this.#commit(replaceTask(state, state.task, insertMaze(this.task, at, maze)), { maze: at });
  }

  /** Removes the open maze; the only maze stays. */
  removeMaze(): void {
    const state = this.store.getState();
    const { length } = this.task.mazes;
    if (length < 2) return;
    const maze = Math.min(state.maze, length - 2);
    this.#commit(replaceTask(state, state.task, removeMaze(this.task, state.maze)), { maze });
  }

  /**
   * Starts a trial of the lesson as a student, or of its open task alone. A program in a trial to
   * solve the task sets the reference values of every task with this content. A lesson that students
   * may have stays as it is: another mark, without an edit, would make their completion codes those
   * of another lesson. A trial as a student shows such a code, too.
   * @returns records that the teacher solved a task
   */
  startTrial(purpose: "try" | "solve"): (task: LessonTask, solution: Solution) => void {
    const isShared = this.#isShared(withoutBlankTexts(this.lesson));
    const setsPar = purpose === "solve" && !isShared;
    return (task, solution) => {
      const { solutions } = this.store.getState();
      this.store.setState({ solutions: withSolution(solutions, task, solution) });
      if (setsPar && solution.program !== null) this.#setPar(task, solution);
    };
  }

  #setPar(task: LessonTask, solution: Solution): void {
    const state = this.store.getState();
    const mark = contentMark(task);
    const par = { lines: solution.lines, seconds: displayedSeconds(solution.ticks) };
    const tasks = state.lesson.tasks.map((each) =>
      contentMark(each) === mark ? { ...each, par } : each,
    );
    this.#commit({ lesson: { ...state.lesson, tasks }, taskIds: state.taskIds });
  }

  undo(): void {
    const { past, future } = this.store.getState();
    const version = past.at(-1);
    if (version === undefined) return;
    this.#show(version, { past: past.slice(0, -1), future: [this.#version(), ...future] });
  }

  redo(): void {
    const { past, future } = this.store.getState();
    const [version, ...rest] = future;
    if (version === undefined) return;
    this.#show(version, { past: [...past, this.#version()], future: rest });
  }

  #show(version: Version, history: Pick<DraftState, "past" | "future">): void {
    this.endGroup();
    this.store.setState({ ...version, ...history });
  }

  #version(): Version {
    const { lesson, taskIds, task, maze } = this.store.getState();
    return { lesson, taskIds, task, maze };
  }

  #commit(
    next: TaskList,
    open: Partial<Pick<Version, "task" | "maze">> = {},
    group: string | null = null,
  ): void {
    const state = this.store.getState();
    const name = group === null ? null : `${group} ${state.taskIds[state.task]} ${state.maze}`;
    const isGrouped = name !== null && name === this.#group;
    this.#group = name;
    const past = isGrouped ? state.past : [...state.past, this.#version()].slice(-MAX_STEPS);
    const { lesson, taskIds } = next;
    this.store.setState({ lesson, taskIds, ...open, past, future: [] });
  }
}

/** The open task of a state. @throws RangeError if the lesson has no task */
export function openTaskOf({ lesson, task }: Pick<Version, "lesson" | "task">): LessonTask {
  const open = lesson.tasks[task] ?? lesson.tasks[0];
  if (open === undefined) throw new RangeError("A lesson has at least one task.");
  return open;
}
