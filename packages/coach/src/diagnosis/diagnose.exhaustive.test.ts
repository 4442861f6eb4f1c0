import { generateMaze, type MazeDocument } from "@corridor/maze";
import {
  CompiledProgram,
  type Condition,
  type ProgramDocument,
  type Rule,
} from "@corridor/program";
import { plainActions, type PlainAction } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { causeLine, type Diagnosis } from "./diagnosis.ts";
import { diagnoseProgram, diagnoseStretch, freePlayTask, type DiagnosisTask } from "./diagnose.ts";
import { falseClaims } from "./testing/claims.ts";

const front = (is: "<" | ">", than: number): Condition => ({ sensor: "front", is, than });
const right = (is: "<" | ">", than: number): Condition => ({ sensor: "right", is, than });
const rule = (when: Condition, action: PlainAction): Rule => ({ when, do: action });
const program = (otherwise: PlainAction, ...rules: Rule[]): ProgramDocument => ({
  format: "corridor/program",
  version: 1,
  name: "",
  default: otherwise,
  rules,
});
const maze = (...blocks: string[]): MazeDocument => ({
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks,
  start: { column: 1, row: 1, heading: "east" },
  goals: [],
});

const reachesGoal: DiagnosisTask["newSolvedCheck"] = () => (robot) => robot.goalTick !== null;

/** In free play: the first bump, or a goal that was not reached in time. */
function diagnosed(where: MazeDocument, what: ProgramDocument, ticks: number): Diagnosis | null {
  return diagnoseProgram(
    { maze: where, program: what, state: new Simulation(where).save() },
    {
      until: ticks,
      bumps: 0,
      newSolvedCheck: where.goals.length > 0 ? reachesGoal : null,
      allows: () => true,
      solvesAll: null,
      mazes: 1,
    },
  );
}

const tree = generateMaze({ kind: "tree", columns: 11, rows: 11, seed: 7, name: "" });
const opening = {
  ...maze("#######", "#.....#", "###.###", "###.###", "#######"),
  goals: [{ column: 3, row: 3 }],
};
const side = {
  ...maze("#########", "#.......#", "####.####", "####.####", "#########"),
  goals: [{ column: 4, row: 3 }],
};
const winding = {
  ...maze("#######", "#...#.#", "###.#.#", "#...#.#", "#.###.#", "#.....#", "#######"),
  goals: [{ column: 5, row: 1 }],
};
const dead = maze("######", "#....#", "######");

describe("the mistakes of the thesis", () => {
  it.each([
    {
      mistake: "Figure 26: “delayed” left out, and a bump",
      where: opening,
      what: program("forward", rule(right(">", 60), "right 90")),
      says: { kind: "not-delayed", isAtEdge: true, side: "right" },
      line: 0,
      fix: { kind: "action", line: 0, action: "delayed right 90" },
    },
    {
      mistake: "Figure 22 with “delayed” left out, in a tree",
      where: tree,
      what: program("forward", rule(right(">", 60), "right 90"), rule(front("<", 50), "left 90")),
      says: { kind: "not-delayed", isAtEdge: true },
      line: 0,
      fix: { kind: "action", line: 0, action: "delayed right 90" },
    },
    {
      mistake: "“delayed” left out and turned round at a wall, so that there is no bump",
      where: winding,
      what: program("forward", rule(right(">", 60), "right 90"), rule(front("<", 50), "turn 180")),
      says: { kind: "not-delayed", isAtEdge: true },
      line: 0,
      fix: { kind: "action", line: 0, action: "delayed right 90" },
    },
    {
      mistake: "Figure 25: delayed where there is no room",
      where: tree,
      what: program(
        "forward",
        rule(right(">", 60), "delayed right 90"),
        rule(front("<", 50), "delayed left 90"),
      ),
      says: { kind: "delayed", needs: 75 },
      line: 1,
      fix: { kind: "action", line: 1, action: "left 90" },
    },
    {
      mistake: "the lines in the wrong order",
      where: side,
      what: program(
        "left 90",
        rule(front(">", 50), "forward"),
        rule(right(">", 60), "delayed right 90"),
      ),
      says: { kind: "order" },
      line: 1,
      fix: { kind: "move", line: 1, to: 0 },
    },
    {
      mistake: "a number that is no distance",
      where: dead,
      what: program("forward", rule(front("<", 5), "turn 180")),
      says: { kind: "too-late", extreme: "never" },
      line: 0,
      fix: { kind: "number", line: 0, number: 50 },
    },
    {
      mistake: "nothing for a wall",
      where: dead,
      what: program("forward"),
      says: { kind: "missing", sensor: "front" },
      line: null,
      fix: { kind: "insert", at: 0 },
    },
  ])("$mistake", ({ where, what, says, line, fix }) => {
    const found = diagnosed(where, what, 60 * 120);
    if (found === null) throw new Error("no failure");
    expect(found.cause).toMatchObject(says);
    expect(causeLine(found)).toBe(line);
    expect(found.fixes[0]).toMatchObject(fix);
    expect(falseClaims(where, what, found, 60 * 120)).toEqual([]);
  });
});

describe("a bump", () => {
  it("starts with the decision that led to it, although two lines drive forward", () => {
    const what = program("forward", rule(front(">", 100), "forward"));
    const event = diagnosed(dead, what, 600)?.event;
    expect(event).toMatchObject({ kind: "bump", line: "default", startedAt: 0, reading: 350 });
  });

  it("at a corner beside the beam is reported as such", () => {
    // It turns at the edge of the opening, and the block beside it reaches 23 cm into its path.
    const early = program("forward", rule({ sensor: "back", is: ">", than: 200 }, "right 90"));
    const found = diagnosed(opening, early, 600);
    if (found === null) throw new Error("no failure");
    expect(found.event).toMatchObject({
      kind: "bump",
      reading: 250,
      contact: { x: 300, y: 200, isCorner: true },
    });
    expect(falseClaims(opening, early, found, 600)).toEqual([]);
  });
});

describe("a change in free play", () => {
  const corridor = maze("#########", "#.......#", "#####.###", "#####.###", "#########");
  const toSide = { ...corridor, goals: [{ column: 5, row: 3 }] };
  const back = (than: number) =>
    program("forward", rule({ sensor: "back", is: ">", than }, "right 90"));

  it("that reaches the goal precedes one that only bumps later", () => {
    const found = diagnosed(toSide, back(100), 1800);
    expect(found?.cause).toMatchObject({ kind: "too-early", better: 450 });
    expect(found?.fixes[0]).toEqual({ kind: "number", line: 0, number: 450 });
  });

  it("is not a number with which the robot stays in its square, or bumps at the same turn later", () => {
    const found = diagnosed(corridor, back(100), 1800);
    const numbers = found?.fixes.flatMap((fix) => (fix.kind === "number" ? [fix.number] : []));
    expect(numbers).toEqual([450]);
  });

  it("is not a number with which the line only stays false until the next bump", () => {
    const what = program("forward", rule(front(">", 50), "left 90"));
    const found = diagnosed(toSide, what, 1800);
    expect(found?.cause).toMatchObject({ kind: "comparison", line: 0 });
    expect(found?.fixes.map(({ kind }) => kind)).not.toContain("number");
  });
});

describe("in free play, what the run shows", () => {
  it("comes before a number that no reading exceeds", () => {
    const what = program("right 90", rule(front("<", 75), "delayed left 90"));
    const found = diagnosed(side, what, 1800);
    expect(found?.cause).toMatchObject({
      kind: "action",
      moment: { line: "default" },
      detail: { kind: "into-wall", side: "right", open: "front" },
    });
  });

  it("is a turn too far from the wall ahead, rather than a missing delay", () => {
    const found = diagnosed(winding, program("right 90", rule(front(">", 100), "forward")), 1800);
    expect(found?.cause).toMatchObject({ kind: "too-short", line: 0, better: 50 });
  });
});

describe("in free play, after another program left the robot beside the middle of a square", () => {
  const wallFollower = (near: number) =>
    program("forward", rule(right(">", 60), "delayed right 90"), rule(front("<", near), "left 90"));
  const untilBump = (robot: Simulation, what: ProgramDocument): Simulation => {
    const run = new ProgramRun(robot, new CompiledProgram(what));
    const { bumps } = robot;
    while (robot.bumps === bumps && robot.tick < 3600) run.step();
    robot.apply({ action: "stop" });
    return robot;
  };
  const afterBump = (what: ProgramDocument): Diagnosis | null => {
    const state = untilBump(new Simulation(winding), wallFollower(75)).save();
    const robot = new Simulation(winding);
    robot.restore(state);
    const { tick } = untilBump(robot, what);
    const task = freePlayTask(winding, tick);
    return diagnoseStretch({ maze: winding, program: what, state }, task, tick, "bump");
  };

  it("a program that reaches the goal from the start is not blamed for a bump", () => {
    const found = afterBump(wallFollower(60));
    expect(found).toMatchObject({ event: { kind: "bump" }, cause: null, solvesFromStart: true });
  });

  it("a program that fails from the start as well gets a cause", () => {
    const found = afterBump(wallFollower(75));
    expect(found?.solvesFromStart).toBeUndefined();
    expect(found?.cause).not.toBeNull();
  });
});

const sensors = ["front", "back", "left", "right"] as const;
const anyCondition: fc.Arbitrary<Condition> = fc.oneof(
  fc.record({
    sensor: fc.constantFrom(...sensors),
    is: fc.constantFrom("<" as const, ">" as const),
    than: fc.constantFrom(4, 30, 50, 60, 75, 100, 125, 150, 250),
  }),
  fc.record({
    sensor: fc.constant("left" as const),
    is: fc.constantFrom("<" as const, ">" as const),
    than: fc.constant("right" as const),
    plus: fc.constantFrom(-50, 0, 1, 50),
  }),
);
const anyProgram = fc
  .record({
    otherwise: fc.constantFrom<PlainAction>("forward", "forward", "left 90", "right 90"),
    rules: fc.array(fc.record({ when: anyCondition, do: fc.constantFrom(...plainActions) }), {
      maxLength: 4,
    }),
  })
  .map(({ otherwise, rules }) => program(otherwise, ...rules));
const anyMaze = fc
  .record({
    kind: fc.constantFrom("tree" as const, "loops" as const, "rooms" as const),
    side: fc.constantFrom(5, 7, 9),
    seed: fc.integer({ min: 0, max: 10_000 }),
  })
  .map(({ kind, side, seed }) => generateMaze({ kind, columns: side, rows: side, seed, name: "" }));

describe("a diagnosis of any program in any maze", () => {
  it("contains no false claims, and names a cause only with a fix that works", () => {
    fc.assert(
      fc.property(anyMaze, anyProgram, (where, what) => {
        const ticks = 60 * 30;
        const found = diagnosed(where, what, ticks);
        if (found === null) return;
        expect(falseClaims(where, what, found, ticks)).toEqual([]);
      }),
      { numRuns: 250 },
    );
  });

  it("is deterministic", () => {
    fc.assert(
      fc.property(anyMaze, anyProgram, (where, what) => {
        expect(diagnosed(where, what, 900)).toEqual(diagnosed(where, what, 900));
      }),
      { numRuns: 20 },
    );
  });
});
