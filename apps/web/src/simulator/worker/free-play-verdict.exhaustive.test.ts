/** In free play the page shows the same verdict as `grade --why` for the same program and maze. */
import { diagnoseFreePlay, type Diagnosis } from "@corridor/coach";
import { generateMaze, type MazeDocument } from "@corridor/maze";
import type { Condition, ProgramDocument, Rule } from "@corridor/program";
import { plainActions } from "@corridor/protocol";
import { Simulation } from "@corridor/simulation";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import * as diagnostics from "./diagnose-run.ts";
import { RunLoop } from "./run-loop.ts";

const FIVE_MINUTES = 5 * 3600;

/** The page's last diagnosis of an untouched run, up to a bump, the goal or a tick. */
function saidOnPage(maze: MazeDocument, program: ProgramDocument, until: number): Diagnosis | null {
  let time = 0;
  const loop = new RunLoop(maze, program, () => time);
  loop.updates.useDiagnostics(diagnostics);
  loop.setSpeed(16);
  loop.run();
  let said: Diagnosis | null = null;
  while (loop.isRunning && loop.snapshot().tick < until) {
    time += 8;
    loop.advance();
    const bumps = loop.updates.take()?.events.flatMap(({ diagnosis }) => diagnosis ?? []) ?? [];
    said = bumps[0] ?? loop.updates.takeDiagnosed()?.diagnosis ?? said;
  }
  if (loop.snapshot().goalReached) return null;
  return said !== null && said.event.tick <= until ? said : null;
}

function gradedWhy(maze: MazeDocument, program: ProgramDocument, until: number): Diagnosis | null {
  const state = new Simulation(maze).save();
  const found = diagnoseFreePlay({ maze, program, state }, until);
  // The page has no time limit in free play.
  return found?.event.kind === "late" ? null : found;
}

const programOf = (...rules: Rule[]): ProgramDocument => ({
  format: "corridor/program",
  version: 1,
  name: "",
  default: "forward",
  rules,
});
const number = (sensor: "front" | "right", is: "<" | ">", than: number): Condition => ({
  sensor,
  is,
  than,
});

/** A ring of 40 cells with the goal in a pocket: a lap takes most of a minute. */
const ring: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: Array.from({ length: 13 }, (_, row) =>
    Array.from({ length: 13 }, (_, column) => {
      const isRing = Math.max(Math.abs(row - 6), Math.abs(column - 6)) === 5;
      return isRing || (column === 6 && (row === 2 || row === 3)) ? "." : "#";
    }).join(""),
  ),
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 6, row: 3 }],
};
const turnsAtWalls = programOf({ when: number("front", "<", 50), do: "right 90" });

describe("the verdict on a robot that drives in circles of most of a minute", () => {
  it("is given by the page", () => {
    expect(saidOnPage(ring, turnsAtWalls, FIVE_MINUTES)?.event).toMatchObject({
      kind: "circles",
      times: 3,
    });
  });

  it("is the same in `grade --why`", () => {
    expect(gradedWhy(ring, turnsAtWalls, FIVE_MINUTES)).toEqual(
      saidOnPage(ring, turnsAtWalls, FIVE_MINUTES),
    );
  });
});

const anyCondition: fc.Arbitrary<Condition> = fc.record({
  sensor: fc.constantFrom("front" as const, "right" as const, "left" as const),
  is: fc.constantFrom("<" as const, ">" as const),
  than: fc.constantFrom(50, 60, 100, 150),
});
const anyRules = fc.array(fc.record({ when: anyCondition, do: fc.constantFrom(...plainActions) }), {
  minLength: 1,
  maxLength: 3,
});
const anyMaze = fc
  .record({
    kind: fc.constantFrom("tree" as const, "loops" as const, "rooms" as const),
    side: fc.constantFrom(5, 9, 13),
    seed: fc.integer({ min: 0, max: 10_000 }),
  })
  .map(({ kind, side, seed }) => generateMaze({ kind, columns: side, rows: side, seed, name: "" }));

describe("any program in any maze", () => {
  it("has one verdict on the page and in `grade --why`", () => {
    fc.assert(
      fc.property(anyMaze, anyRules, (maze, rules) => {
        const program = programOf(...rules);
        expect(saidOnPage(maze, program, FIVE_MINUTES)).toEqual(
          gradedWhy(maze, program, FIVE_MINUTES),
        );
      }),
      { numRuns: 100 },
    );
  });
});
