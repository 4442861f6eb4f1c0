/**
 * Replays a run from its inputs: a maze with a program, or a maze with commands at given ticks. The
 * same inputs result in the same digest in every JavaScript engine.
 */
import type { MazeDocument } from "@corridor/maze";
import type { TimedCommand } from "@corridor/protocol";
import { ProgramRun, type Decider } from "./program-run.ts";
import { Simulation } from "./simulation.ts";
import { SnapshotDigest } from "./snapshot-digest.ts";

export interface Inputs {
  maze: MazeDocument;
  /** a compiled program, or commands in tick order */
  driver: Decider | readonly TimedCommand[];
}

/**
 * Runs the inputs from tick 0.
 * @returns the digest of the snapshots of all ticks: 16 hexadecimal digits
 */
export function replayDigest({ maze, driver }: Inputs, ticks: number): string {
  const simulation = new Simulation(maze);
  const digest = new SnapshotDigest();
  if ("decide" in driver) {
    const run = new ProgramRun(simulation, driver);
    for (let tick = 0; tick < ticks; tick++) {
      run.step();
      digest.add(simulation.report());
    }
    return digest.toString();
  }
  let next = 0;
  for (let tick = 0; tick < ticks; tick++) {
    for (let due = driver[next]; due?.tick === tick; due = driver[++next]) {
      simulation.apply(due.command);
    }
    simulation.step();
    digest.add(simulation.report());
  }
  return digest.toString();
}
