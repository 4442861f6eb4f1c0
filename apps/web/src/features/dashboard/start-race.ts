/** Reads the programs of a race, and runs them on the workers of a pool. */
import { isProgram, type LessonDocument } from "@corridor/challenge";
import { handInsOf } from "@corridor/link";
import { countLines, type ProgramDocument } from "@corridor/program";
import type { Racer } from "@corridor/protocol";
import type { RacedRun } from "../../simulator/protocol/pool-messages.ts";
import type { WorkerPool } from "../../simulator/worker-pool.ts";
import { taskMaze } from "./task-maze.ts";

export interface RaceStart {
  lesson: LessonDocument;
  /** from 1 */
  task: number;
  /** in which the robots race, as in tiles */
  maze: string;
  racers: readonly Racer[];
}

export interface RaceRobot {
  /** students with its program */
  count: number;
  lines: number;
  run: RacedRun;
}

/**
 * @param task from 1
 * @returns the robots in the order of `racers`, without those whose code is unreadable; null if the
 *   workers do not load
 */
export async function startRace(
  pool: Pick<WorkerPool, "run">,
  { lesson, task, maze: name, racers }: RaceStart,
): Promise<RaceRobot[] | null> {
  const document = lesson.tasks[task - 1];
  const maze = taskMaze(lesson, task, name);
  const starters = racers.flatMap(({ code, count }) => {
    const program = programOf(code, lesson);
    return program === null ? [] : [{ program, count }];
  });
  if (document === undefined || maze === null || starters.length === 0) return [];
  const programs = starters.map(({ program }) => program);
  const robots: RaceRobot[] = [];
  let left = programs.length;
  return new Promise((resolve) => {
    pool.run({ kind: "race", race: { task: document, maze, programs } }, programs.length, {
      onResult: (result, at) => {
        const starter = starters[at];
        if (result.kind !== "race" || starter === undefined) return;
        const { count, program } = starter;
        robots[at] = { count, lines: countLines(program.rules), run: result.run };
        if (--left === 0) resolve(robots);
      },
      onEnd: () => resolve(null),
    });
  });
}

/** null: not a program of this lesson */
function programOf(code: string, lesson: LessonDocument): ProgramDocument | null {
  const lines = handInsOf(code, lesson);
  const read = lines.ok ? lines.value[0]?.read : undefined;
  return read?.ok === true && isProgram(read.value.attempt) ? read.value.attempt : null;
}
