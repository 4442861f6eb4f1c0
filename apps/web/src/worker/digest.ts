/**
 * One run's digest, in chunks of ticks: shows that this engine gives the same bits as any other.
 */
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { MazeDocument } from "@corridor/maze";
import { ProgramRun, Simulation, SnapshotDigest } from "@corridor/simulation";

export interface DigestRequest {
  maze: MazeDocument;
  program: ProgramDocument;
  ticks: number;
  /** ticks between two early decisions, as between two frames of a page */
  chunk: number;
}

/** Runs the program and returns the digest of all its snapshots. */
export function digestOf({ maze, program, ticks, chunk }: DigestRequest): string {
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  const digest = new SnapshotDigest();
  for (let tick = 0; tick < ticks; tick++) {
    // The early decision of a frame must not change what happens, only when it is computed.
    if (tick % chunk === 0) run.decide();
    run.step();
    digest.add(simulation.report());
  }
  return digest.toString();
}
