/** The verdicts of a check in several mazes: they agree where one change repairs all of them. */
import { taskOf } from "@corridor/challenge";
import type { Cause } from "@corridor/coach";
import type { Condition, ProgramDocument, Rule } from "@corridor/program";
import type { PlainAction } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { checkProgram } from "../testing/check-program.ts";
import { lines } from "./mission.ts";
import { causes, solved } from "./testing/causes.ts";

const front = (is: "<" | ">", than: number, action: PlainAction): Rule => ({
  when: { sensor: "front", is, than },
  do: action,
});
const side = (sensor: "left" | "right", action: PlainAction): Rule => ({
  when: { sensor, is: ">", than: 60 },
  do: action,
});
const compared = (is: "<" | ">", action: PlainAction): Rule => {
  const when: Condition = { sensor: "left", is, than: "right", plus: 1 };
  return { when, do: action };
};

/** The causes in the mazes that fail. */
function named(id: string, program: ProgramDocument): Cause[] {
  return causes(id, program).filter((cause) => cause !== null);
}

describe("where one change repairs every maze", () => {
  it("each maze names it, although the robot turns to and fro in one of them", () => {
    const program = lines("right 90", front(">", 50, "forward"), front("<", 50, "left 90"));
    const missing = { kind: "missing", sensor: "right", isWall: false };
    expect(named("every-maze", program)).toMatchObject([missing, missing]);
  });
});

describe("where no single change repairs every maze", () => {
  it("each maze names the mistake that it shows", () => {
    const program = lines("forward", front("<", 100, "left 90"), side("right", "right 90"));
    expect(causes("every-maze", program)).toMatchObject([
      { kind: "too-early", line: 0, better: 50 },
      { kind: "action", moment: { line: 0 }, detail: { kind: "into-wall", open: "right" } },
      { kind: "not-delayed", moment: { line: 1 }, isAtEdge: true },
    ]);
  });
});

describe("the first wrong turn is named", () => {
  it("not the turns that follow it, when two lines turn to the same side", () => {
    const program = lines(
      "forward",
      front(">", 50, "forward"),
      compared("<", "right 90"),
      compared(">", "right 90"),
    );
    expect(causes("farthest-distance", program)).toMatchObject([
      null,
      { kind: "action", moment: { line: 2, tick: 396 }, detail: { kind: "into-wall" } },
    ]);
  });

  it.each([
    { wall: "left", open: "right" },
    { wall: "right", open: "left" },
  ] as const)("when a program follows the $wall wall and turns to it", ({ wall, open }) => {
    const program = lines(
      "forward",
      side(wall, `delayed ${wall} 90`),
      front("<", 50, `${wall} 90`),
    );
    const toWall = { kind: "action", moment: { line: 1 }, detail: { side: wall, open } };
    expect(named("right-wall", program)[0]).toMatchObject(toWall);
    const changed = lines(
      "forward",
      side(wall, `delayed ${wall} 90`),
      front("<", 50, `${open} 90`),
    );
    expect(named("right-wall", changed)).toEqual([]);
  });
});

describe("two lines that undo each other", () => {
  it("are advised to turn, beside changes that turn", () => {
    const program = lines("forward", front("<", 50, "left 90"), front("<", 100, "reverse"));
    const mission = solved.find(({ id }) => id === "every-maze");
    if (mission === undefined) throw new Error("no such mission");
    const [first] = checkProgram({ task: taskOf(mission.challenge), program }).diagnoses;
    expect(first?.cause).toMatchObject({
      kind: "action",
      moment: { line: 1 },
      detail: { kind: "undoing", other: "default" },
    });
    for (const fix of first?.fixes ?? []) expect(JSON.stringify(fix)).toMatch(/ (90|180)"/);
  });
});
