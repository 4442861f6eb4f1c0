/** Sends the numbers of the class to its big screens, whenever they change. */
import { useEffect, useState } from "react";
import { summaryOf } from "../../model/classroom/class-summary.ts";
import {
  isClassPaused,
  resultsTask,
  type Dashboard,
  type DashboardState,
} from "../../model/classroom/dashboard.ts";
import { mostBumped } from "../../model/classroom/most-bumped.ts";
import { chosenMaze, raceField, type RaceChoice } from "../../model/classroom/racers.ts";
import { ScreenPriority } from "../../model/classroom/screen-priority.ts";
import { openTask } from "../../model/classroom/standing.ts";
import type { ScreenNumbers } from "@corridor/protocol";

interface ScreensChoice {
  /** whose run is on the big screens; null: none */
  student: number | null;
  /** the maze of the race */
  race: RaceChoice | null;
  /** Another device controls the big screens: they do not show the run of that student any more. */
  onRunEnd: () => void;
}

export function useScreens(dashboard: Dashboard, { student, race, onRunEnd }: ScreensChoice): void {
  const [priorities] = useState(() => new ScreenPriority());
  useEffect(() => {
    const endRun = (): void => {
      if (student === null || !priorities.isLost(dashboard.store.getState().displayed)) return;
      priorities.endRun();
      onRunEnd();
    };
    const send = (): void => {
      const state = dashboard.store.getState();
      const numbers = numbersOf(state, race);
      const program = student === null ? null : programOf(state, student);
      if (numbers === null) return;
      const now = Date.now() - (state.classroom?.time.ahead ?? 0);
      const choices = { student, race, task: state.chosenTask };
      const priority = priorities.of(choices, now, state.displayed);
      dashboard.send({ type: "screens", numbers, student, program, priority });
    };
    send();
    return dashboard.store.subscribe((state, before) => {
      if (state.displayed !== before.displayed) endRun();
      const isSame =
        state.students === before.students &&
        state.verifications === before.verifications &&
        state.bumps === before.bumps &&
        state.programs === before.programs &&
        state.classroom === before.classroom &&
        state.lesson === before.lesson &&
        state.chosenTask === before.chosenTask;
      if (!isSame) send();
    });
  }, [dashboard, student, race, onRunEnd, priorities]);
}

/** The program of the open task as a link text; null: not known, or a drive */
function programOf({ students, programs }: DashboardState, number: number): string | null {
  const student = students.get(number);
  const read = programs.get(number);
  if (student === undefined || read === undefined || read.program === null) return null;
  return read.task === openTask(student) ? read.link : null;
}

/** Of the task that the dashboard shows, too. */
function numbersOf(state: DashboardState, choice: RaceChoice | null): ScreenNumbers | null {
  const { classroom, lesson, students, shown, verifications, bumps } = state;
  if (classroom === null || lesson === null) return null;
  const task = resultsTask(state);
  const isPaused = isClassPaused(state);
  const { expected } = classroom;
  const summary = summaryOf(task, students, shown, verifications, { expected, isPaused });
  const { maze, cells, counts } = mostBumped(task, bumps);
  const { racers, missing } = raceField(task, verifications);
  return {
    task,
    solved: summary.solved,
    all: summary.all,
    medianMs: summary.medianMs,
    lines: summary.commonLines,
    maze,
    bumps: cells.slice(0, 400).map(({ column, row, count }) => ({ column, row, count })),
    bumpCounts: counts,
    racers,
    raceMaze: chosenMaze(lesson, task, choice),
    missing: missing.length,
  };
}
