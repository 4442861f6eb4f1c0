/** A run of a race, as poses that the page displays. */
import { checkMaze, type LessonTask } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import { ProgramRun, Simulation } from "@corridor/simulation";
import { TICKS_PER_POSE, type RacedRun } from "../protocol/pool-messages.ts";

/** Runs until the task is solved or the attempt has failed, as its check does. */
export function raceRun(task: LessonTask, maze: MazeDocument, program: ProgramDocument): RacedRun {
  const { ticks, failure } = checkMaze(task, maze, program, null);
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  const poses = new Float32Array(3 * (Math.ceil(ticks / TICKS_PER_POSE) + 1));
  let at = 0;
  const add = (): void => {
    const { x, y, heading } = simulation.pose;
    poses.set([x, y, heading], at);
    at += 3;
  };
  add();
  while (simulation.tick < ticks) {
    run.step();
    if (simulation.tick % TICKS_PER_POSE === 0 || simulation.tick === ticks) add();
  }
  return { poses, ticks, isSolved: failure === null };
}
