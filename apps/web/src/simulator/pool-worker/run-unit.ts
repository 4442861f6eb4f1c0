/** Runs one unit of a job. Deterministic, without a page. */
import { isProgram, runCheckUnit } from "@corridor/challenge";
import { emptyProgram } from "@corridor/program";
import { Recording, type WrittenRun } from "@corridor/recording";
import type { PoolJob, PoolResult, RunToRecord } from "../protocol/pool-messages.ts";
import { diagnoseAttempt } from "./diagnose-attempt.ts";
import { raceRun } from "./race-run.ts";
import { mazeOf, minutesFor, tryMaze } from "./maze-trial.ts";

/** @param unit from 0 @throws RangeError if the job has no such unit */
export function runUnit(job: PoolJob, unit: number): PoolResult {
  switch (job.kind) {
    case "trial": {
      const { program, mazes, first } = job;
      const seed = first + unit;
      const maze = mazeOf(mazes, seed);
      const trial = { seed, maze, ...tryMaze(maze, program, minutesFor(mazes.side)) };
      return { kind: "trial", trial };
    }
    case "check":
      return { kind: "check", outcome: runCheckUnit(job.check, unit) };
    case "record": {
      const run = job.runs[unit];
      if (run === undefined) throw new RangeError(`no unit ${unit}`);
      return { kind: "record", written: recordAttempt(run) };
    }
    case "race": {
      const { task, maze, programs } = job.race;
      const program = programs[unit];
      if (program === undefined) throw new RangeError(`no unit ${unit}`);
      return { kind: "race", run: raceRun(task, maze, program) };
    }
    case "diagnose": {
      const attempt = job.attempts[unit];
      if (attempt === undefined) throw new RangeError(`no unit ${unit}`);
      return { kind: "diagnose", diagnosis: diagnoseAttempt(attempt) };
    }
  }
}

/** Runs an attempt again, and records the run so that the page can display it. */
export function recordAttempt({ maze, attempt, ticks }: RunToRecord): WrittenRun {
  if (isProgram(attempt)) {
    const recording = new Recording(maze, attempt);
    while (recording.run.tick < ticks) recording.step();
    return recording.toDocument(maze.name);
  }
  const recording = new Recording(maze, emptyProgram());
  recording.addInput({ do: "driver", driver: "me" });
  let next = 0;
  while (recording.run.tick < ticks) {
    for (let due = attempt[next]; due?.tick === recording.run.tick; due = attempt[++next]) {
      recording.addInput({ do: "command", command: due.command });
    }
    recording.step();
  }
  return recording.toDocument(maze.name);
}
