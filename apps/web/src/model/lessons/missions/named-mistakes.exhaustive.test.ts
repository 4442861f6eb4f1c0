/** Of several changes that remove a failure, the diagnosis names the student's mistake. */
import type { ProgramDocument, Rule } from "@corridor/program";
import type { PlainAction } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { lines } from "./mission.ts";
import { causes } from "./testing/causes.ts";

describe("of several lines whose change passes", () => {
  const front = (is: "<" | ">", than: number, action: PlainAction): Rule => ({
    when: { sensor: "front", is, than },
    do: action,
  });
  const rightOpen: Rule = { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" };
  const leftLonger = (plus: number, action: PlainAction): Rule => ({
    when: { sensor: "left", is: ">", than: "right", plus },
    do: action,
  });

  it.each([65, 75])("the one that turned beside the middle of a square is named (%i)", (than) => {
    const program = lines("forward", rightOpen, front("<", than, "left 90"));
    expect(causes("right-wall", program)).toMatchObject([{ kind: "too-early", line: 1 }]);
  });

  it("the one after which the robot turns in the middle of squares is named", () => {
    const program = lines("right 90", front(">", 50, "forward"), leftLonger(200, "left 90"));
    expect(causes("farthest-distance", program)).toMatchObject([null, { line: 1, better: 100 }]);
  });

  it.each([80, 90, 100, 150])("the number of a wall ahead comes before a delay (%i)", (than) => {
    const program = lines("right 90", front(">", than, "forward"), leftLonger(1, "left 90"));
    const early = { kind: "too-short", line: 0 };
    expect(causes("farthest-distance", program)).toMatchObject([early, early]);
    const own = lines("forward", front("<", Math.min(than, 100), "right 90"));
    expect(causes("own-line", own)).toMatchObject([{ kind: "too-early", line: 0, better: 50 }]);
  });

  it.each([70, 75])(
    "a number that only compensates for an earlier turn comes last (%i)",
    (than) => {
      const early = front("<", than, "left 90");
      const ofFront = { kind: "too-early", better: 50 };
      for (const [program, line] of [
        [lines("forward", rightOpen, early), 1],
        [lines("forward", early, rightOpen), 0],
      ] as const) {
        const found = causes("every-maze", program).filter((cause) => cause !== null);
        expect(found).toMatchObject([
          { ...ofFront, line },
          { ...ofFront, line },
        ]);
      }
    },
  );

  it.each(["right-wall", "every-maze"])("a missing delay comes before an order (%s)", (id) => {
    const early: Rule = { ...rightOpen, do: "right 90" };
    const program = lines("left 90", early, front(">", 50, "forward"));
    const found = causes(id, program).filter((cause) => cause !== null);
    expect(found.length).toBeGreaterThan(0);
    for (const cause of found)
      expect(cause).toMatchObject({ kind: "not-delayed", moment: { line: 0 } });
  });

  it("a delayed turn without room comes before the number of another line", () => {
    const program = lines(
      "delayed right 90",
      front(">", 50, "forward"),
      leftLonger(1, "delayed left 90"),
    );
    expect(causes("farthest-distance", program)).toMatchObject([
      { kind: "delayed", moment: { line: 1 } },
      { kind: "delayed", moment: { line: "default" } },
    ]);
  });

  it("a line is not called missing where the program has one for that place", () => {
    for (const cause of causes("every-maze", lines("forward", front("<", 50, "turn 180")))) {
      expect(cause).not.toMatchObject({ kind: "missing", sensor: "front" });
    }
  });

  it("a turn to a wall is named as such, and before an action that only happens to help", () => {
    const toWall = { kind: "action", moment: { line: 0 }, detail: { kind: "into-wall" } };
    const leftOpen: Rule = { when: { sensor: "left", is: ">", than: 60 }, do: "delayed left 90" };
    const atRight = (action: PlainAction): Rule => ({ ...rightOpen, do: action });
    const atWall = front("<", 50, "delayed left 90");
    const turned = lines("forward", atRight("left 90"), leftOpen, atWall);
    expect(causes("faulty-line", turned)).toMatchObject([toWall]);
    const back = front("<", 50, "turn 180");
    const delayed = lines(
      "forward",
      atRight("delayed left 90"),
      { ...leftOpen, do: "forward" },
      back,
    );
    expect(causes("faulty-line", delayed)).toMatchObject([toWall]);
  });

  it("a delayed turn into an opening is not called a turn to a wall", () => {
    const program = lines("forward", front("<", 130, "delayed left 90"));
    const [first] = causes("every-maze", program);
    expect(first).not.toMatchObject({ detail: { kind: "into-wall" } });
  });
});

describe("of two mistakes", () => {
  const front = (is: "<" | ">", than: number, action: PlainAction): Rule => ({
    when: { sensor: "front", is, than },
    do: action,
  });
  const side = (sensor: "left" | "right", than: number, action: PlainAction): Rule => ({
    when: { sensor, is: ">", than },
    do: action,
  });
  const leftLonger = (is: "<" | ">", action: PlainAction): Rule => ({
    when: { sensor: "left", is, than: "right", plus: 1 },
    do: action,
  });

  it.each([80, 150, 250])("the better number is the same in each maze (%i)", (than) => {
    const program = lines(
      "forward",
      side("right", 60, "delayed right 90"),
      front("<", than, "left 90"),
    );
    const early = { kind: "too-early", line: 1, better: 50 };
    expect(causes("every-maze", program)).toMatchObject([early, early, early]);
  });

  it.each<{
    id: string;
    maze: number;
    is: string;
    program: ProgramDocument;
    kind: string;
    line: number;
  }>([
    {
      id: "own-line",
      maze: 0,
      is: "else",
      program: lines("right 90", front(">", 100, "forward")),
      kind: "too-short",
      line: 0,
    },
    {
      id: "every-maze",
      maze: 0,
      is: "own",
      program: lines("forward", front("<", 100, "left 90")),
      kind: "too-early",
      line: 0,
    },
    {
      id: "right-wall",
      maze: 0,
      is: "own",
      program: lines("forward", front("<", 100, "right 90")),
      kind: "too-early",
      line: 0,
    },
    {
      id: "every-maze",
      maze: 0,
      is: "else",
      program: lines("left 90", front(">", 100, "forward"), side("left", 60, "left 90")),
      kind: "too-short",
      line: 0,
    },
    {
      id: "farthest-distance",
      maze: 0,
      is: "upper",
      program: lines("forward", front(">", 100, "forward"), leftLonger(">", "left 90")),
      kind: "too-short",
      line: 0,
    },
  ])(
    "a turn too far from the wall ahead is blamed on the number, not on a missing delay ($id, $is line)",
    ({ id, maze, program, kind, line }) => {
      expect(causes(id, program)[maze]).toMatchObject({ kind, line, better: 50 });
    },
  );

  it("a number that is no distance is named also if it is not the only mistake", () => {
    const program = lines(
      "forward",
      side("right", 4, "delayed right 90"),
      front("<", 100, "left 90"),
    );
    const found = causes("every-maze", program);
    expect(found[1]).toMatchObject({ kind: "too-early", line: 0, extreme: "always" });
  });

  it("an order is named where the upper line turns to a wall and the lower one drives on", () => {
    const program = lines("forward", leftLonger("<", "right 90"), front(">", 50, "forward"));
    const order = { kind: "order", line: 1, moment: { line: 0 } };
    expect(causes("farthest-distance", program)).toMatchObject([order, order]);
  });

  it("a line that every maze needs comes before a turn that is wrong in one of them", () => {
    const program = lines("forward", front("<", 50, "left 90"), front("<", 50, "right 90"));
    const missing = { kind: "missing", sensor: "right", isWall: false };
    expect(causes("every-maze", program)).toMatchObject([null, missing, missing]);
  });

  it("a line that every maze needs is blamed in no maze, where another one is wrong in all", () => {
    const program = lines("forward", front("<", 50, "left 90"), side("right", 60, "forward"));
    const wrong = { kind: "action", moment: { line: 1 } };
    expect(causes("every-maze", program)).toMatchObject([null, wrong, wrong]);
  });

  it("an order that leads past the wall comes before the line that drove into it", () => {
    const program = lines(
      "forward",
      { when: { sensor: "right", is: "<", than: 60 }, do: "forward" },
      front("<", 30, "left 90"),
    );
    const found = causes("every-maze", program);
    expect([found[0], found[2]]).toMatchObject([{ kind: "order" }, { kind: "order" }]);
  });

  it("no order is named that only postpones the failure", () => {
    const program = lines(
      "forward",
      side("right", 50, "delayed right 90"),
      front("<", 100, "left 90"),
    );
    for (const cause of causes("right-wall", program)) expect(cause?.kind).not.toBe("order");
  });

  it("a line for an opening is not called missing if its number is wrong", () => {
    const program = lines(
      "left 90",
      front(">", 50, "forward"),
      side("right", 250, "delayed right 90"),
    );
    for (const cause of causes("every-maze", program)) expect(cause?.kind).not.toBe("missing");
  });

  it("a turn to the side with room does not have the wrong sign", () => {
    const program = lines(
      "forward",
      side("right", 60, "delayed right 90"),
      front("<", 50, "left 90"),
      { when: { sensor: "right", is: "<", than: 60 }, do: "left 90" },
    );
    for (const id of ["right-wall", "every-maze"])
      for (const cause of causes(id, program)) expect(cause?.kind).not.toBe("comparison");
  });

  it("a turn to a wall is named in each maze, although no single change solves one of them", () => {
    const toWall = { kind: "action", moment: { line: 0 }, detail: { kind: "into-wall" } };
    const program = lines("forward", front("<", 50, "left 90"));
    expect(causes("farthest-distance", program)).toMatchObject([toWall, toWall]);
  });

  it("no later line is blamed after the robot left the middle of the squares", () => {
    const program = lines(
      "forward",
      front("<", 50, "forward"),
      side("right", 60, "delayed right 90"),
      front("<", 75, "left 90"),
    );
    expect(causes("right-wall", program)).toEqual([null]);
  });

  it("a line that turns too early is not called a missing line for a wall", () => {
    const program = lines("forward", side("right", 60, "right 90"), front("<", 250, "left 90"));
    expect(causes("right-wall", program)).toMatchObject([
      { kind: "missing", isWall: false, sensor: "front", moment: { line: 1 } },
    ]);
  });
});

describe("a line too many", () => {
  const when = (sensor: "front" | "right" | "back" | "left", is: "<" | ">", than: number) => ({
    sensor,
    is,
    than,
  });
  const follow: Rule[] = [
    { when: when("right", ">", 60), do: "delayed right 90" },
    { when: when("front", "<", 50), do: "left 90" },
  ];

  it.each<{ id: string; at: number; extra: Rule }>([
    { id: "right-wall", at: 2, extra: { when: when("front", ">", 50), do: "reverse" } },
    { id: "right-wall", at: 2, extra: { when: when("back", ">", 200), do: "right 90" } },
    { id: "right-wall", at: 1, extra: { when: when("front", "<", 80), do: "right 90" } },
    { id: "every-maze", at: 1, extra: { when: when("left", ">", 60), do: "right 90" } },
    { id: "every-maze", at: 0, extra: { when: when("front", ">", 55), do: "right 90" } },
  ])("has no better number: $id, line $at", ({ id, at, extra }) => {
    const program = lines("forward", ...follow.toSpliced(at, 0, extra));
    const found = causes(id, program).filter((cause) => cause !== null);
    expect(found.length).toBeGreaterThan(0);
    for (const cause of found) expect(cause).toMatchObject({ kind: "extra", line: at });
  });
});
