import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, truthOf, type ProgramDocument, type Rule } from "@corridor/program";
import { ProgramRun, Simulation } from "@corridor/simulation";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { findBlame } from "./find-blame.ts";
import { nearProgram } from "./testing/near-programs.ts";

const TICKS = 1200;

/** A side way in the middle of a corridor. */
const sideWay: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["#######", "#.....#", "###.###", "###.###", "#######"],
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 3, row: 3 }],
};

function programOf(...rules: Rule[]): ProgramDocument {
  return { format: "corridor/program", version: 1, name: "", default: "forward", rules };
}

function passesIn(maze: MazeDocument, program: ProgramDocument): boolean {
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  while (simulation.tick < TICKS && simulation.bumps === 0 && simulation.goalTick === null) {
    run.step();
  }
  return simulation.goalTick !== null;
}

function blameOf(program: ProgramDocument) {
  return findBlame({
    program,
    maze: sideWay,
    ticks: TICKS,
    endsAtBump: true,
    passes: (other) => passesIn(sideWay, other),
  });
}

const atOpening = { sensor: "right", is: ">", than: 60 } as const;
const atWall = { sensor: "front", is: "<", than: 50 } as const;

describe("the line to blame", () => {
  it("is the turn at the edge of an opening, though another line met the corner", () => {
    const blame = blameOf(programOf({ when: atOpening, do: "right 90" }));
    expect(blame).toMatchObject({ kind: "early-turn", line: 0, action: "right 90", drivesOn: 50 });
  });

  it("is the delayed turn that begins at a wall", () => {
    const blame = blameOf(programOf({ when: atWall, do: "delayed left 90" }));
    expect(blame).toMatchObject({ kind: "no-room", line: 0, needs: 75 });
  });

  it("is a line that stands too low, where the other order passes", () => {
    const always: Rule = { when: { sensor: "front", is: ">", than: 50 }, do: "forward" };
    const turn: Rule = { when: atOpening, do: "delayed right 90" };
    const blame = blameOf(programOf(always, turn));
    expect(blame).toMatchObject({ kind: "overruled", line: 1, above: 0, sensor: "right" });
    expect(Math.round(blame?.kind === "overruled" ? blame.reading : 0)).toBe(250);
  });

  it("is none that is there, where a turn to the opening is missing", () => {
    const blame = blameOf(programOf({ when: atWall, do: "turn 180" }));
    expect(blame).toMatchObject({ kind: "no-turn", side: "right" });
  });

  it("is the line that asks for blocks instead of cm", () => {
    const blocks: Rule = { when: { sensor: "back", is: ">", than: 3 }, do: "left 90" };
    expect(blameOf(programOf(blocks))).toMatchObject({ kind: "always-true", line: 0, number: 3 });
  });

  it("is the one that backs off from where otherwise drives to", () => {
    const back: Rule = { when: atWall, do: "reverse" };
    expect(blameOf(programOf(back))).toMatchObject({ kind: "undoing", line: 0, other: "default" });
  });

  it("is what it is said to be, in any program that fails", () => {
    fc.assert(
      fc.property(nearProgram(4), (program) => {
        fc.pre(!passesIn(sideWay, program));
        const blame = blameOf(program);
        if (blame === null || blame.kind === "no-turn" || blame.kind === "nowhere") return;
        const { line } = blame;
        const rule = line === "default" ? null : program.rules[line];
        const action = line === "default" ? program.default : rule?.do;
        const isAction = !("action" in blame) || blame.action === action;
        const isAlwaysTrue = [25, 50, 999].every((reading) => {
          const readings = { front: reading, right: reading, back: reading, left: reading };
          return truthOf(rule?.when ?? null, readings)?.isTrue === true;
        });
        expect([isAction, blame.kind !== "always-true" || isAlwaysTrue]).toEqual([true, true]);
      }),
      { numRuns: 60 },
    );
  });
});
