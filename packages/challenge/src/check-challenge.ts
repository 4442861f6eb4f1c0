/**
 * Checks an attempt at a task by running it in every maze, without a page. The result is
 * deterministic, because the page runs the same simulation. `checks.seconds` limits each maze.
 */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import { type LineRef, TICKS_PER_SECOND, type TimedCommand } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";
import { findViolation } from "./allowed-program.ts";
import { GoalTracker } from "./goal-tracker.ts";
import type { Task } from "./task-schema.ts";
import type { Decision, Failure, FailureCode, MazeOutcome, Verdict } from "./verdict.ts";

/** A program, or the commands of a drive by hand or by a script, in tick order. */
export type Attempt = ProgramDocument | readonly TimedCommand[];

/** Runs an attempt in the given mazes and returns whether it passes, with its first failure. */
export function checkChallenge(task: Task, attempt: Attempt): Verdict {
  const violation = violationOf(task, attempt);
  if (violation !== null) return { passed: false, failure: violation, mazes: [] };
  const mazes = task.mazes.map((maze, index) => checkMaze(task, maze, attempt, index));
  const failure = mazes.find((each) => each.failure !== null)?.failure ?? null;
  return { passed: failure === null, failure, mazes };
}

/** Returns why a task does not allow an attempt, whatever its maze, or null. */
export function violationOf(task: Task, attempt: Attempt): Failure | null {
  return isProgram(attempt) ? findViolation(task, attempt) : findDriveViolation(task);
}

/** Drives the robot tick by tick and stores the last decision. */
interface Driver {
  /** chooses the motion of the next tick */
  decide: () => void;
  step: () => void;
  line: () => LineRef | null;
  decision: () => Decision;
}

/**
 * Runs an attempt that the task allows in one maze.
 * @param index of the maze in the task; null for another one
 */
export function checkMaze(
  { goal, checks }: Task,
  maze: MazeDocument,
  attempt: Attempt,
  index: number | null,
): MazeOutcome {
  const simulation = new Simulation(maze);
  const driver = isProgram(attempt)
    ? programDriver(simulation, attempt)
    : commandDriver(simulation, attempt);
  const tracker = new GoalTracker(goal, maze);
  const { columns } = sizeOf(maze);
  const limit = checks.seconds * TICKS_PER_SECOND;
  const maxBumps = checks.bumps ?? Number.POSITIVE_INFINITY;
  let failure: Failure | null = null;
  let isMet = false;
  /** number of consecutive ticks without motion */
  let stillTicks = 0;
  while (!isMet && failure === null && simulation.tick < limit) {
    driver.decide();
    if (goal.kind === "stop")
      stillTicks = simulation.report().motion === "stop" ? stillTicks + 1 : 0;
    driver.step();
    tracker.visit(simulation.cell);
    if (simulation.bumps > maxBumps) {
      failure = failed("bump", maxBumps, simulation.bumps, driver.decision());
    } else {
      isMet = tracker.isMet(simulation, stillTicks > 1);
    }
  }
  if (!isMet) failure ??= timeout();
  return {
    failure,
    ticks: simulation.tick,
    bumps: simulation.bumps,
    visited: tracker.visited,
    open: tracker.open,
    distance: simulation.distance,
  };

  /** The failure when the time limit is reached. */
  function timeout(): Failure {
    switch (goal.kind) {
      case "reach":
        return failed("not-reached", tracker.open, tracker.visited);
      case "visit":
      case "last":
        return failed("not-visited", tracker.open, tracker.visited);
      case "stop": {
        const reading = simulation.report().sensors[goal.sensor];
        return failed("not-stopped", reading < goal.from ? goal.from : goal.to, reading);
      }
      case "drive":
        return failed("too-short", goal.distance, simulation.distance);
    }
  }

  function failed(
    code: FailureCode,
    needed: number,
    found: number,
    decision: Decision | null = null,
  ): Failure {
    const { cell, tick } = simulation;
    const place = { column: cell % columns, row: Math.floor(cell / columns) };
    return { code, maze: index, tick, line: driver.line(), place, needed, found, decision };
  }
}

function programDriver(simulation: Simulation, program: ProgramDocument): Driver {
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  const readings = new Float64Array(4);
  let decidedAt = 0;
  return {
    decide: () => {
      if (!simulation.isManoeuvring) {
        readings.set(simulation.readings);
        decidedAt = simulation.tick;
      }
      run.decide();
    },
    step: () => run.step(),
    line: () => run.line,
    decision: () => ({
      tick: decidedAt,
      action: run.line === "default" ? program.default : (program.rules[run.line]?.do ?? null),
      readings: namedReadings(readings),
    }),
  };
}

function commandDriver(simulation: Simulation, commands: readonly TimedCommand[]): Driver {
  let next = 0;
  const readings = new Float64Array(4);
  return {
    decide: () => {
      readings.set(simulation.readings);
      for (let due = commands[next]; due?.tick === simulation.tick; due = commands[++next]) {
        simulation.apply(due.command);
      }
    },
    step: () => simulation.step(),
    line: () => null,
    decision: () => ({
      tick: Math.max(0, simulation.tick - 1),
      action: null,
      readings: namedReadings(readings),
    }),
  };
}

function namedReadings(readings: Float64Array): Decision["readings"] {
  const [front = 0, right = 0, back = 0, left = 0] = readings;
  return { front, right, back, left };
}

/** Whether an attempt is a program, not the commands of a drive. */
export function isProgram(attempt: Attempt): attempt is ProgramDocument {
  return "rules" in attempt;
}

/** Commands do not name their sender: they are a violation if the task allows only a program. */
function findDriveViolation({ allowed }: Task): Failure | null {
  if (allowed.drivers.some((driver) => driver !== "program")) return null;
  return {
    code: "driver",
    maze: null,
    tick: null,
    line: null,
    place: null,
    needed: null,
    found: null,
    decision: null,
  };
}
