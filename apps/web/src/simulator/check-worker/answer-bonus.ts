/** Checks bonus missions by running programs in mazes, without a page. Deterministic. */
import { checkChallenge } from "@corridor/challenge";
import {
  CELL,
  countOpenCells,
  isBlock,
  sizeOf,
  type Cell,
  type MazeDocument,
} from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import { TICKS_PER_SECOND } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";
import type { BonusAnswer, BonusAnswers, BonusQuestion } from "../protocol/bonus-request.ts";

/** Ticks between two points of a trail: 10 units of a straight line. */
const TRAIL_EVERY = 6;

export function answerBonus(question: BonusQuestion): BonusAnswer {
  switch (question.kind) {
    case "mazes":
      return { kind: "mazes", value: checkMazes(question) };
    case "defeat": {
      const { maze, program, seconds } = question;
      return { kind: "defeat", value: checkDefeat(maze, program, seconds) };
    }
    case "trail":
      return { kind: "trail", value: firstTrail(question) };
  }
}

function checkMazes({
  task,
  program,
}: Extract<BonusQuestion, { kind: "mazes" }>): BonusAnswers["mazes"] {
  const { mazes } = checkChallenge(task, program);
  const solved = mazes.filter(({ failure }) => failure === null);
  return {
    solved: solved.length,
    all: task.mazes.length,
    ticks: solved.reduce((sum, { ticks }) => sum + ticks, 0),
    failed: mazes.flatMap(({ failure }, at) => (failure === null ? [] : [at])),
  };
}

function checkDefeat(
  maze: MazeDocument,
  program: ProgramDocument,
  seconds: number,
): BonusAnswers["defeat"] {
  if (maze.goals.length === 0) return { state: "no-goal" };
  const reachable = reachableFrom(maze, maze.start);
  const { columns } = sizeOf(maze);
  if (!maze.goals.some(({ column, row }) => reachable.has(row * columns + column))) {
    return { state: "no-path" };
  }
  const run = drive(maze, program, seconds);
  return run.isReached
    ? { state: "reached", ticks: run.simulation.tick }
    : { state: "defeated", seconds, squares: countOpenCells(maze) };
}

/** Open cells that are reachable from this one, as `row * columns + column`. */
function reachableFrom(maze: MazeDocument, start: Cell): Set<number> {
  const { columns, rows } = sizeOf(maze);
  const found = new Set([start.row * columns + start.column]);
  for (const cell of found) {
    const column = cell % columns;
    const row = Math.floor(cell / columns);
    for (const [x, y] of [
      [column + 1, row],
      [column - 1, row],
      [column, row + 1],
      [column, row - 1],
    ] as const) {
      const isInside = x >= 0 && y >= 0 && x < columns && y < rows;
      if (isInside && !isBlock(maze, x, y)) found.add(y * columns + x);
    }
  }
  return found;
}

function firstTrail({
  attempts,
  seconds,
}: Extract<BonusQuestion, { kind: "trail" }>): BonusAnswers["trail"] {
  for (const { maze, program } of attempts) {
    const { isReached, simulation, points } = drive(maze, program, seconds);
    if (isReached) return { maze, pose: { ...simulation.report().pose }, points };
  }
  return null;
}

function drive(maze: MazeDocument, program: ProgramDocument, seconds: number) {
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  const { column, row } = maze.start;
  const points = [(column + 0.5) * CELL, (row + 0.5) * CELL];
  const limit = seconds * TICKS_PER_SECOND;
  let isReached = false;
  while (!isReached && simulation.tick < limit) {
    run.decide();
    run.step();
    const { pose, goalReached } = simulation.report();
    isReached = goalReached;
    if (isReached || simulation.tick % TRAIL_EVERY === 0) points.push(pose.x, pose.y);
  }
  return { simulation, isReached, points };
}
