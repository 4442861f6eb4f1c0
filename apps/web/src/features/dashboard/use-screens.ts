/** Sends the numbers of the class to its big screens, whenever they change. */
import { useEffect } from "react";
import { summaryOf } from "../../model/classroom/class-summary.ts";
import {
  isClassPaused,
  resultsTask,
  type Dashboard,
  type DashboardState,
} from "../../model/classroom/dashboard.ts";
import { mostBumped } from "../../model/classroom/most-bumped.ts";
import { chosenMaze, raceField, type RaceChoice } from "../../model/classroom/racers.ts";
import type { ScreenNumbers } from "@corridor/protocol";

/**
 * @param student whose run is on the big screens; null: none
 * @param choice the maze of the race
 */
export function useScreens(
  dashboard: Dashboard,
  student: number | null,
  choice: RaceChoice | null,
): void {
  useEffect(() => {
    const send = (): void => {
      const numbers = numbersOf(dashboard.store.getState(), choice);
      if (numbers !== null) dashboard.send({ type: "screens", numbers, student });
    };
    send();
    return dashboard.store.subscribe((state, before) => {
      const isSame =
        state.students === before.students &&
        state.verifications === before.verifications &&
        state.bumps === before.bumps &&
        state.classroom === before.classroom &&
        state.lesson === before.lesson &&
        state.chosenTask === before.chosenTask;
      if (!isSame) send();
    });
  }, [dashboard, student, choice]);
}

/** Of the task that the dashboard shows, too. */
function numbersOf(state: DashboardState, choice: RaceChoice | null): ScreenNumbers | null {
  const { classroom, lesson, students, shown, verifications, bumps } = state;
  if (classroom === null || lesson === null) return null;
  const task = resultsTask(state);
  const isPaused = isClassPaused(state);
  const { expected } = classroom;
  const summary = summaryOf(task, students, shown, verifications, { expected, isPaused });
  const { maze, cells } = mostBumped(task, bumps);
  const { racers, missing } = raceField(task, verifications);
  return {
    task,
    solved: summary.solved,
    all: summary.all,
    medianMs: summary.medianMs,
    lines: summary.commonLines,
    maze,
    bumps: cells.slice(0, 400).map(({ column, row, count }) => ({ column, row, count })),
    racers,
    raceMaze: chosenMaze(lesson, task, choice),
    missing: missing.length,
  };
}
