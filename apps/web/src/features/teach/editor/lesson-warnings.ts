/**
 * What a teacher should know before sharing a lesson: tasks that no student can solve, and tasks that
 * the teacher has not solved.
 */
import type { LessonDocument, LessonTask } from "@corridor/challenge";
import {
  CELL,
  countOpenCells,
  distancesFromStart,
  sizeOf,
  UNREACHABLE,
  type MazeDocument,
} from "@corridor/maze";
import { TICKS_PER_SECOND } from "@corridor/protocol";
import { DRIVE_STEP, ROBOT_RADIUS } from "@corridor/simulation";
import { solutionOf, type Solution, type Solutions } from "../../../model/teaching/solution.ts";

export type WarningCode =
  /** students see a lesson without a name */
  | "unnamed"
  /** a maze has no goal, and the robot must reach one */
  | "no-goal"
  /** no path leads to a goal */
  | "no-path"
  /** the robot must visit every square, and no path leads to some */
  | "closed-squares"
  /** the start program has more lines than the task allows */
  | "too-few-lines"
  /** the teacher's solution needs more time than the task allows */
  | "slower-solution"
  /** no robot is fast enough for the time limit */
  | "too-little-time"
  /** the teacher has not solved the task */
  | "unsolved";

export interface LessonWarning {
  code: WarningCode;
  /** index of the task; null if the warning is about the lesson */
  task: number | null;
  /** index of the given maze; null if the warning is about the whole task */
  maze: number | null;
}

/** Speed of `forward`, in units per second. */
const FULL_SPEED = DRIVE_STEP * TICKS_PER_SECOND;

export function warningsOf(lesson: LessonDocument, solutions: Solutions): LessonWarning[] {
  const unnamed: LessonWarning = { code: "unnamed", task: null, maze: null };
  return [
    ...(lesson.name.trim() === "" ? [unnamed] : []),
    ...lesson.tasks.flatMap((task, at) =>
      taskWarnings(task, solutionOf(solutions, task)).map((warning) => ({ ...warning, task: at })),
    ),
  ];
}

function taskWarnings(
  task: LessonTask,
  solution: Solution | null,
): Pick<LessonWarning, "code" | "maze">[] {
  const paths = task.mazes.flatMap((maze, at) => {
    const code = pathWarning(task, maze);
    return code === null ? [] : [{ code, maze: at }];
  });
  const warnings: Pick<LessonWarning, "code" | "maze">[] = [...paths];
  if ((task.program?.rules.length ?? 0) > task.allowed.lines) {
    warnings.push({ code: "too-few-lines", maze: null });
  }
  const isTooSlow = solution !== null && solution.ticks > task.checks.seconds * TICKS_PER_SECOND;
  const late = solution === null ? task.mazes.findIndex((maze) => isTooShort(task, maze)) : -1;
  if (isTooSlow) warnings.push({ code: "slower-solution", maze: null });
  else if (late >= 0) warnings.push({ code: "too-little-time", maze: late });
  if (solution === null) warnings.push({ code: "unsolved", maze: null });
  return warnings;
}

function pathWarning({ goal }: LessonTask, maze: MazeDocument): WarningCode | null {
  if (goal.kind === "reach") {
    if (maze.goals.length === 0) return "no-goal";
    return stepsToGoal(maze) === null ? "no-path" : null;
  }
  if (goal.kind !== "visit") return null;
  const reached = distancesFromStart(maze).filter((steps) => steps !== UNREACHABLE).length;
  return reached < countOpenCells(maze) ? "closed-squares" : null;
}

/** Number of squares to the nearest goal; null if no path leads to one. */
function stepsToGoal(maze: MazeDocument): number | null {
  const { columns } = sizeOf(maze);
  const distances = distancesFromStart(maze);
  const steps = maze.goals
    .map(({ column, row }) => distances[row * columns + column] ?? UNREACHABLE)
    .filter((each) => each !== UNREACHABLE);
  return steps.length === 0 ? null : Math.min(...steps);
}

/** Whether the time limit is shorter than the shortest way at full speed. */
function isTooShort(task: LessonTask, maze: MazeDocument): boolean {
  const { allowed, checks } = task;
  // Programs turn by multiples of 90 degrees. Other drivers may take the diagonal in a room.
  const shortcut = allowed.drivers.every((driver) => driver === "program") ? 1 : Math.SQRT2;
  return shortestWay(task, maze) / shortcut > checks.seconds * FULL_SPEED;
}

/** Lower bound of the distance that a robot drives, in units. */
function shortestWay({ goal }: LessonTask, maze: MazeDocument): number {
  switch (goal.kind) {
    case "reach": {
      const steps = stepsToGoal(maze) ?? 0;
      // The whole robot must be inside the goal's square.
      return steps === 0 ? 0 : steps * CELL - CELL / 2 + ROBOT_RADIUS;
    }
    case "visit":
      return Math.max(0, (countOpenCells(maze) - 1) * CELL - CELL / 2);
    case "drive":
      return goal.distance;
    case "stop":
    case "last":
      return 0;
  }
}
