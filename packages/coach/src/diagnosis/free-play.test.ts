/** What a student reads about a failed run in free play, where no task proves a change. */
import { generateMaze, type MazeDocument } from "@corridor/maze";
import type { Condition, ProgramDocument, Rule } from "@corridor/program";
import type { PlainAction, SensorName } from "@corridor/protocol";
import { Simulation } from "@corridor/simulation";
import { describe, expect, it } from "vitest";
import { diagnoseFreePlay, diagnoseProgram, freePlayTask } from "./diagnose.ts";
import { causeLine, type Diagnosis } from "./diagnosis.ts";
import { falseClaims } from "./testing/claims.ts";

const MINUTE_TICKS = 3600;

const when = (sensor: SensorName, is: "<" | ">", than: number): Condition => ({ sensor, is, than });
const rule = (condition: Condition, action: PlainAction): Rule => ({ when: condition, do: action });
const program = (otherwise: PlainAction, ...rules: Rule[]): ProgramDocument => ({
  format: "corridor/program",
  version: 1,
  name: "",
  default: otherwise,
  rules,
});
const generated = (kind: "tree" | "rooms", side: number, seed: number): MazeDocument =>
  generateMaze({ kind, columns: side, rows: side, seed, name: "" });

/** The diagnosis of a run in free play, whose claims are checked. */
function diagnosed(maze: MazeDocument, what: ProgramDocument): Diagnosis {
  const state = new Simulation(maze).save();
  const found = diagnoseFreePlay({ maze, program: what, state }, MINUTE_TICKS);
  if (found === null) throw new Error("no failure");
  expect(falseClaims(maze, what, found, MINUTE_TICKS * 2)).toEqual([]);
  return found;
}

const leftLonger: Condition = { sensor: "left", is: ">", than: "right", plus: 1 };
const room = generated("rooms", 9, 5);
const smallRoom = generated("rooms", 7, 3);

describe("in a room, where a side is always open,", () => {
  it("a missing line for a wall is named, not another sensor for a line that drives well", () => {
    const what = program(
      "right 90",
      rule(when("left", ">", 50), "forward"),
      rule(leftLonger, "left 90"),
    );
    const { cause, fixes } = diagnosed(room, what);
    expect(cause).toMatchObject({ kind: "missing", sensor: "front", isWall: true });
    expect(fixes[0]).toMatchObject({
      kind: "insert",
      rule: { when: { sensor: "front", is: "<" } },
    });
  });

  it("a missing line for a wall is named, not another sign", () => {
    const what = program("left 90", rule(leftLonger, "forward"));
    const { cause } = diagnosed(generated("tree", 7, 3), what);
    expect(cause).toMatchObject({ kind: "missing", isWall: true, moment: { line: 0 } });
  });

  it("another sensor is named for a line that was never true", () => {
    const what = program(
      "forward",
      rule(when("right", ">", 60), "delayed right 90"),
      rule(when("back", "<", 50), "left 90"),
    );
    const { cause, fixes } = diagnosed(generated("tree", 7, 3), what);
    expect(cause).toMatchObject({ kind: "sensor", line: 1 });
    expect(fixes[0]).toMatchObject({ kind: "condition", when: { sensor: "front" } });
  });

  it("a turn away from the only open side is named, not a later delay", () => {
    const what = program(
      "forward",
      rule(when("right", ">", 60), "delayed right 90"),
      rule(when("front", "<", 50), "turn 180"),
    );
    const { cause, fixes } = diagnosed(smallRoom, what);
    expect(cause).toMatchObject({ kind: "action", moment: { line: 1, tick: 240 } });
    expect(fixes[0]).toEqual({ kind: "action", line: 1, action: "left 90" });
  });

  it("a delayed turn with room ahead is not blamed for a bump seconds later", () => {
    const what = program(
      "forward",
      rule(when("left", ">", 60), "delayed left 90"),
      rule(when("front", "<", 50), "delayed left 90"),
    );
    const { event, cause } = diagnosed(room, what);
    expect(cause).toMatchObject({ kind: "too-early", line: 0 });
    expect(cause?.moment.tick).toBeGreaterThan(0);
    expect(event.tick - (cause?.moment.tick ?? 0)).toBeLessThan(120);
  });
});

describe("a bump that no plausible change removes", () => {
  it("blames no line, and states the decision and the room that it needed", () => {
    const what = program(
      "forward",
      rule(when("left", ">", 60), "delayed left 90"),
      rule(when("front", "<", 50), "delayed left 90"),
    );
    const found = diagnosed(generated("rooms", 7, 1), what);
    expect(found).toMatchObject({
      event: { kind: "bump", line: 0, action: "delayed left 90", decidedAt: 204, needs: 75 },
      cause: null,
      fixes: [],
    });
    expect(causeLine(found)).toBeNull();
  });
});

describe("the moment of a missing line", () => {
  it("is the decision that led to the bump, not an earlier opening that the robot passed", () => {
    const maze: MazeDocument = {
      format: "corridor/maze",
      version: 1,
      name: "",
      blocks: [
        "#######",
        "###.#.#",
        "###.#.#",
        "###.#.#",
        "###.#.#",
        "###.#.#",
        "#.....#",
        "#######",
      ],
      start: { column: 1, row: 6, heading: "east" },
      goals: [{ column: 5, row: 1 }],
    };
    const state = new Simulation(maze).save();
    const found = diagnoseProgram(
      { maze, program: program("forward"), state },
      {
        ...freePlayTask(maze, MINUTE_TICKS),
        allows: ({ rules }) => rules.every((each) => each.when?.sensor === "left"),
      },
    );
    expect(found).toMatchObject({
      event: { kind: "bump", line: "default" },
      cause: { kind: "missing", sensor: "left", moment: { readings: { left: 550 } } },
    });
    expect(found?.cause?.moment.tick).toBeGreaterThan(200);
  });
});

describe("two lines that undo each other", () => {
  it("are advised to turn, and offered turns only", () => {
    const what = program("forward", rule(when("front", "<", 50), "reverse"));
    const { cause, fixes } = diagnosed(smallRoom, what);
    expect(cause).toMatchObject({ kind: "action", detail: { kind: "undoing" } });
    expect(fixes.length).toBeGreaterThan(0);
    for (const fix of fixes)
      expect(JSON.stringify(fix)).toMatch(/"line":0,"action":"[a-z ]+(?:90|180)"/);
  });
});
