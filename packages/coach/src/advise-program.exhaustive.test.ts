import { generateTree, mazePresets, type MazeDocument } from "@corridor/maze";
import { arbitraryMaze } from "@corridor/maze/testing";
import {
  CompiledProgram,
  conditionKinds,
  conditionOf,
  numberOf,
  programPresets,
  evaluateCondition,
  type ProgramDocument,
} from "@corridor/program";
import { arbitraryProgram, paperPrograms } from "@corridor/program/testing";
import { plainActions } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { Advice } from "./advice.ts";
import { adviseProgram } from "./advise-program.ts";
import { applyFix } from "./apply-fix.ts";

/** Numbers as students type them, including impossible readings. */
const typed = fc.constantFrom(
  0,
  10,
  20,
  24,
  25,
  30,
  49,
  50,
  51,
  60,
  75,
  76,
  100,
  150,
  300,
  700,
  5000,
);
const studentRule = fc.constantFrom(...conditionKinds).chain((kind) =>
  fc.record({
    when: fc.option(
      fc
        .oneof(typed, fc.constantFrom(1, 2))
        .chain((number) =>
          kind.than === "right"
            ? fc.constantFrom(number, -number).map((plus) => conditionOf(kind, plus))
            : fc.constant(conditionOf(kind, number)),
        ),
      { freq: 9 },
    ),
    do: fc.constantFrom(...plainActions),
  }),
);
const studentProgram: fc.Arbitrary<ProgramDocument> = fc
  .record({
    rules: fc.array(studentRule, { maxLength: 7 }),
    default: fc.constantFrom(...plainActions),
  })
  .map((parts) => ({ format: "corridor/program", version: 1, name: "", ...parts }));

const tree = generateTree({ columns: 11, rows: 11, seed: 5, name: "" });

/** "right > 60" and what to do then. */
type Line = [when: string, action: ProgramDocument["default"]];

function programOf(...lines: Line[]): ProgramDocument {
  return {
    format: "corridor/program",
    version: 1,
    name: "",
    default: "forward",
    rules: lines.map(([when, action]) => ({ when: whenOf(when), do: action })),
  };
}

/** "right > 60", "left > right + 1" or "" for [Do nothing]. */
function whenOf(text: string): ProgramDocument["rules"][number]["when"] {
  const [sensor, is, than, , plus] = text.split(" ");
  const kind = conditionKinds.find(
    (each) =>
      each.sensor === sensor &&
      each.is === is &&
      each.than === (than === "right" ? "right" : "number"),
  );
  return kind === undefined ? null : conditionOf(kind, Number(plus ?? than));
}

const kindsOf = (advice: readonly Advice[]) => advice.map(({ line, kind }) => ({ line, kind }));

describe("programs that are right", () => {
  const right = [
    ...paperPrograms.filter(({ outcome }) => outcome !== "incorrect").map(({ program }) => program),
    ...programPresets.map(({ program }) => program),
  ];

  it.each(right)("$name gets no advice in any maze of the menu", (program) => {
    for (const { maze } of mazePresets) expect(adviseProgram(program, maze)).toEqual([]);
    expect(adviseProgram(program, tree)).toEqual([]);
  });
});

describe("the paper's wrong programs", () => {
  const figure = (number: number) => {
    const found = paperPrograms.find((each) => each.figure === number)?.program;
    if (found === undefined) throw new Error(`no Figure ${number}`);
    return found;
  };

  it("Figure 25: the delayed turn with a front condition becomes the turn of Figure 22", () => {
    const [advice, ...others] = adviseProgram(figure(25), tree);
    expect(others).toEqual([]);
    expect(advice).toEqual({
      kind: "delayed-about-front",
      line: 1,
      why: "near",
      side: "left",
      needs: 75,
      fix: { kind: "action", line: 1, action: "left 90" },
    });
    const withFix = advice?.fix ? applyFix(figure(25), advice.fix) : null;
    expect(withFix?.rules).toEqual(figure(22).rules);
  });

  it("Figure 26: both of its turns are changed, and it is Figure 22", () => {
    let program = figure(26);
    expect(kindsOf(adviseProgram(program, tree))).toEqual([
      { line: 0, kind: "immediate-into-opening" },
      { line: 1, kind: "delayed-about-front" },
    ]);
    for (let [advice] = adviseProgram(program, tree); advice?.fix;) {
      program = applyFix(program, advice.fix);
      [advice] = adviseProgram(program, tree);
    }
    expect(program.rules).toEqual(figure(22).rules);
  });

  it("Figure 24: it has none of the four mistakes, so there is no advice", () => {
    expect(adviseProgram(figure(24), tree)).toEqual([]);
  });
});

describe("a line that can never decide", () => {
  it.each([
    [
      "goes above the line that always wins",
      ["front > 50", "front > 60"],
      { kind: "move", line: 1, to: 0 },
    ],
    [
      "goes away where it says the same again",
      ["right > 60", "right > 60"],
      { kind: "delete", line: 1 },
    ],
    [
      "goes above both lines that share it",
      ["front > 50", "front < 60", "left > 60"],
      { kind: "move", line: 2, to: 0 },
    ],
  ] as const)("%s", (_, lines, fix) => {
    const actions = ["forward", "turn 180", "reverse"] as const;
    const program = programOf(...lines.map((when, at) => [when, actions[at] ?? "stop"] as Line));
    const advice = adviseProgram(program, tree).find(({ line }) => line === lines.length - 1);
    expect(advice).toMatchObject({ kind: "never-decides", fix });
  });

  it("is deleted if it has the same action as the line above", () => {
    const program = programOf(["front > 50", "forward"], ["front > 60", "forward"]);
    expect(adviseProgram(program, tree)[0]?.fix).toEqual({ kind: "delete", line: 1 });
  });

  it("may be the default action", () => {
    const program = programOf(["front > 50", "forward"], ["front < 60", "left 90"]);
    expect(adviseProgram(program, tree)).toEqual([
      { kind: "never-decides", line: "default", above: [0, 1], fix: null },
    ]);
  });

  it("is never a line without a condition", () => {
    const program = programOf(["", "reverse"], ["front < 50", "turn 180"], ["", "reverse"]);
    expect(adviseProgram(program, tree)).toEqual([]);
  });
});

describe("a condition that is never true here", () => {
  const corridor: MazeDocument = {
    ...tree,
    blocks: ["#########", "#.......#", "#########"],
    start: { column: 1, row: 1, heading: "east" },
    goals: [],
  };

  it.each([
    ["front > 1000", "farthest", { kind: "number", line: 0, number: 50 }],
    ["right > 700", "farthest", { kind: "number", line: 0, number: 60 }],
    ["front < 20", "nearest", { kind: "number", line: 0, number: 50 }],
    ["left > right + 690", "difference", { kind: "number", line: 0, number: 1 }],
    ["left < right + -690", "difference", { kind: "number", line: 0, number: 1 }],
  ] as const)("%s", (when, limit, fix) => {
    expect(adviseProgram(programOf([when, "turn 180"]), corridor)).toMatchObject([
      { kind: "never-true-here", line: 0, limit, fix },
    ]);
  });

  it.each(["front > 600", "front < 25", "front < 26", "left > right + 600"])(
    "is not %s",
    (when) => {
      expect(adviseProgram(programOf([when, "turn 180"]), corridor)).toEqual([]);
    },
  );
});

describe("turns at the wrong moment", () => {
  it.each([
    ["a delayed turn just before a wall", ["front < 75", "delayed left 90"], "delayed-about-front"],
    [
      "a delayed turn because the front is free",
      ["front > 100", "delayed right 90"],
      "delayed-about-front",
    ],
    ["a turn into an opening", ["right > 60", "right 90"], "immediate-into-opening"],
    [
      "a turn to the farther side on the way",
      ["left > right + 1", "left 90"],
      "immediate-into-opening",
    ],
    ["the same to the right", ["left < right + 0", "right 90"], "immediate-into-opening"],
  ] as const)("%s", (_, line, kind) => {
    expect(kindsOf(adviseProgram(programOf([...line]), tree))).toEqual([{ line: 0, kind }]);
  });

  it.each([
    ["a delayed turn with room for it", [["front < 100", "delayed left 90"]]],
    [
      "a delayed turn after the side was asked",
      [
        ["right < 60", "forward"],
        ["front > 50", "delayed right 90"],
      ],
    ],
    [
      "a turn into an opening in front of a wall",
      [
        ["front > 50", "forward"],
        ["right > 60", "right 90"],
      ],
    ],
    ["a turn away from the open side", [["right > 60", "left 90"]]],
    ["a turn beside a wall", [["right > 40", "right 90"]]],
    [
      "a turn for which no opening is left",
      [
        ["right > 60", "delayed right 90"],
        ["right > 55", "right 90"],
      ],
    ],
  ] as const)("is not %s", (_, lines) => {
    expect(adviseProgram(programOf(...lines.map(([a, b]) => [a, b] as Line)), tree)).toEqual([]);
  });

  it("are not reported for a robot that only turns", () => {
    const program = { ...programOf(["right > 60", "right 90"]), default: "stop" as const };
    expect(adviseProgram(program, tree)).toEqual([]);
  });

  it("are not reported in a room without corners", () => {
    const room = {
      ...tree,
      blocks: ["....", "....", "...."],
      start: { ...tree.start, column: 0 },
      goals: [],
    };
    expect(adviseProgram(programOf(["right > 60", "right 90"]), room)).toEqual([]);
  });

  it("bump each time that a delayed turn has too little room", () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 30, max: 75 }),
        fc.integer({ min: 0, max: 999 }),
        (than, seed) => {
          const program = programOf([`front < ${than}`, "delayed left 90"]);
          const maze = generateTree({ columns: 7, rows: 7, seed, name: "" });
          const simulation = new Simulation(maze);
          const run = new ProgramRun(simulation, new CompiledProgram(program));
          for (let tick = 0; tick < 1200 && run.line === "default"; tick++) run.step();
          const { bumps } = simulation;
          for (let tick = 0; tick < 60; tick++) run.step();
          expect(run.decisions[1]).toBeGreaterThan(0);
          expect(simulation.bumps).toBeGreaterThan(bumps);
        },
      ),
      { numRuns: 100 },
    );
  });
});

describe("every advice", () => {
  it("on a condition that is never true is correct in any run", () => {
    fc.assert(
      fc.property(
        studentProgram,
        arbitraryMaze,
        fc.integer({ min: -180, max: 180 }),
        (program, maze, degrees) => {
          const advised = adviseProgram(program, maze).flatMap((each) =>
            each.kind === "never-true-here" ? [program.rules[each.line]?.when ?? null] : [],
          );
          const simulation = new Simulation(maze);
          // A student may have turned the robot before the program starts.
          simulation.apply({ action: "turn", degrees });
          while (simulation.isManoeuvring) simulation.step();
          const run = new ProgramRun(simulation, new CompiledProgram(program));
          let wrong = 0;
          for (let tick = 0; tick < 900; tick++) {
            run.step();
            const { sensors } = simulation.report();
            for (const when of advised)
              if (evaluateCondition(when, sensors)?.isTrue === true) wrong++;
          }
          expect(wrong).toBe(0);
        },
      ),
      { numRuns: 300 },
    );
  });

  it("on a line that never decides is correct in any run", () => {
    fc.assert(
      fc.property(studentProgram, arbitraryMaze, (program, maze) => {
        const advised = adviseProgram(program, maze).filter(({ kind }) => kind.startsWith("never"));
        const run = new ProgramRun(new Simulation(maze), new CompiledProgram(program));
        for (let tick = 0; tick < 900; tick++) run.step();
        for (const { line } of advised) {
          expect(run.decisions[line === "default" ? 0 : line + 1]).toBe(0);
        }
      }),
      { numRuns: 300 },
    );
  });

  it("is resolved by its fix without new advice of its kind, and every line has a fix", () => {
    let fixes = 0;
    fc.assert(
      fc.property(studentProgram, (program) => {
        const before = adviseProgram(program, tree);
        for (const advice of before) {
          expect(advice.fix === null).toBe(advice.line === "default");
          if (advice.fix === null) continue;
          fixes++;
          const after = adviseProgram(applyFix(program, advice.fix), tree);
          const count = (list: Advice[]) => list.filter(({ kind }) => kind === advice.kind).length;
          expect(count(after)).toBe(Math.min(count(after), count(before) - 1));
          expect(after.length).toBeLessThan(before.length);
        }
      }),
      { numRuns: 1000 },
    );
    expect(fixes).toBeGreaterThan(500);
  });

  it("that deletes a line changes no decision", () => {
    fc.assert(
      fc.property(studentProgram, arbitraryMaze, (program, maze) => {
        for (const { fix } of adviseProgram(program, maze)) {
          if (fix?.kind !== "delete") continue;
          const runs = [program, applyFix(program, fix)].map(
            (each) => new ProgramRun(new Simulation(maze), new CompiledProgram(each)),
          );
          for (let tick = 0; tick < 300; tick++) {
            for (const run of runs) run.step();
            const lines = runs.map(({ line }) => line);
            const shifted = Number(lines[1]) >= fix.line ? Number(lines[1]) + 1 : lines[1];
            expect(shifted).toBe(lines[0]);
          }
        }
      }),
      { numRuns: 100 },
    );
  });

  it("is ordered by line, at most one per line, for any valid program and maze", () => {
    fc.assert(
      fc.property(arbitraryProgram, arbitraryMaze, (program, maze) => {
        const lines = adviseProgram(program, maze).map(({ line }) =>
          line === "default" ? program.rules.length : line,
        );
        expect(lines).toEqual([...new Set(lines)].toSorted((a, b) => a - b));
        for (const line of lines) {
          const when = program.rules[line]?.when;
          expect(when === undefined || (when !== null && Number.isFinite(numberOf(when)))).toBe(
            true,
          );
        }
      }),
      { numRuns: 100 },
    );
  });
});
