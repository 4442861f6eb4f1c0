import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { z } from "zod";
import { classFields, joinRequestSchema, paceSchema, pauseRequestSchema } from "./class.ts";
import { progressSchema } from "./class-progress.ts";
import { MAX_TILE_LENGTH, tileSchema, type Tile } from "./class-tile.ts";
import { readValue } from "./document-reader.ts";
import { PAIRING_LETTERS } from "./pairing.ts";

const creation = z.strictObject(classFields);
const tile: Tile = {
  seq: 1,
  task: 1,
  maze: "g1",
  state: "writing",
  pose: [150, 150, 90],
  path: "",
  line: null,
  tick: 0,
  bumps: 0,
  passes: null,
};

describe("a code of a class", () => {
  it.each(["BCDFGH", "bcd fgh", " BCD-FGH ", "b c d f g h"])("accepts %j as typed", (code) => {
    expect(joinRequestSchema.parse({ code })).toEqual({ code: "BCDFGH" });
  });

  it.each(["", "BCDFG", "BCDFGHJ", "ABCDEF", "BCDFG1", `BCDFGH${" ".repeat(40)}`, 6, null])(
    "rejects %j",
    (code) => {
      const read = readValue(joinRequestSchema, { code });
      expect(read).toMatchObject({ ok: false, problems: [{ path: "code" }] });
    },
  );

  it("reads any six letters, in any case and with any spaces", () => {
    const letter = fc.constantFrom(...PAIRING_LETTERS.split(""));
    const typed = fc.tuple(letter, fc.boolean(), fc.constantFrom("", " ", "-"));
    fc.assert(
      fc.property(fc.array(typed, { minLength: 6, maxLength: 6 }), (parts) => {
        const shown = parts.map(
          ([each, isLow, after]) => (isLow ? each.toLowerCase() : each) + after,
        );
        const code = parts.map(([each]) => each).join("");
        expect(joinRequestSchema.parse({ code: shown.join("") })).toEqual({ code });
      }),
    );
  });
});

describe("a request for a class", () => {
  it("needs neither names nor a number of students", () => {
    expect(creation.parse({})).toEqual({ names: null, expected: null });
  });

  it.each([
    { names: ["Ada"] },
    { names: ["x".repeat(24)] },
    { names: Array.from({ length: 256 }, (_, at) => `Name ${at}`) },
    { names: ["عمر", "李 明"] },
    { expected: 1 },
    { expected: 200 },
  ])("accepts $names $expected", (fields) => {
    expect(creation.safeParse(fields).success).toBe(true);
  });

  it.each([
    { fields: { names: [] }, path: "names" },
    { fields: { names: Array.from({ length: 257 }, (_, at) => `${at}`) }, path: "names" },
    { fields: { names: ["Ada", "Ada"] }, path: "names" },
    { fields: { names: [""] }, path: "names[0]" },
    { fields: { names: ["x".repeat(25)] }, path: "names[0]" },
    { fields: { names: [" Ada"] }, path: "names[0]" },
    { fields: { names: ["Ada\nLovelace"] }, path: "names[0]" },
    { fields: { expected: 0 }, path: "expected" },
    { fields: { expected: 201 }, path: "expected" },
    { fields: { expected: 1.5 }, path: "expected" },
  ])("rejects $path in $fields", ({ fields, path }) => {
    expect(readValue(creation, fields)).toMatchObject({ ok: false, problems: [{ path }] });
  });
});

describe("what a teacher sets", () => {
  it.each([10, 1_800])("permits a pause of %d seconds", (seconds) => {
    expect(pauseRequestSchema.safeParse({ seconds }).success).toBe(true);
  });

  it.each([9, 1_801, 60.5, "60", null])("rejects a pause of %j seconds", (seconds) => {
    expect(pauseRequestSchema.safeParse({ seconds }).success).toBe(false);
  });

  it.each([0, 13, "2"])("rejects a pace up to task %j", (to) => {
    expect(paceSchema.safeParse({ to }).success).toBe(false);
  });
});

describe("a tile", () => {
  it("fits its longest form into its message", () => {
    const longest: Tile = {
      ...tile,
      seq: Number.MAX_SAFE_INTEGER,
      maze: "u1000",
      state: "writing",
      pose: [12345.12345678901, -12345.12345678901, 359.1234567890123],
      path: "n100".repeat(100),
      line: "default",
      tick: Number.MAX_SAFE_INTEGER,
      bumps: Number.MAX_SAFE_INTEGER,
      passes: 1_010,
    };
    expect(tileSchema.safeParse(longest).success).toBe(true);
    const message = JSON.stringify({ type: "tile", tile: longest });
    expect(message.length).toBeLessThanOrEqual(MAX_TILE_LENGTH);
  });

  it.each([
    { path: "x4" },
    { path: "n1".repeat(201) },
    { maze: "t1" },
    { maze: "g0" },
    { pose: [1, 2] },
    { pose: [1, 2, 360] },
    { pose: [Number.NaN, 2, 3] },
    { state: "stuck" },
    { task: 13 },
    { line: -1 },
    { passes: 2_000 },
    { tick: 0.5 },
  ])("is rejected with %j", (change) => {
    expect(tileSchema.safeParse({ ...tile, ...change }).success).toBe(false);
  });
});

describe("a progress record", () => {
  it.each([
    { kind: "opened", lesson: "0a1b2c3d4", task: 1 },
    { kind: "check", task: 1, changed: true, passes: 3, mazes: 50, failure: null },
    {
      kind: "check",
      task: 1,
      changed: true,
      passes: 3,
      mazes: 50,
      bumpPlaces: [{ maze: "u31", column: 4, row: 2 }],
      failure: { code: "bump", line: 0 },
    },
    { kind: "hint", task: 1, hint: 6 },
    { kind: "solved", task: 12, lines: null, code: "3.AAAA" },
    { kind: "survey", answers: [{ id: "navigation", answer: 5 }] },
    { kind: "survey", answers: [{ id: "navigation", answer: null }] },
  ])("accepts $kind", (event) => {
    expect(progressSchema.safeParse(event).success).toBe(true);
  });

  it.each([
    { kind: "cheated", task: 1 },
    { kind: "opened", lesson: "0a1b2c3d4", task: 0 },
    { kind: "check", task: 1, changed: true, passes: 3, mazes: 0, failure: null },
    { kind: "hint", task: 1, hint: 7 },
    { kind: "solved", task: 1, lines: 2, code: "x".repeat(4_097) },
    { kind: "survey", answers: [{ id: "navigation", answer: 6 }] },
    { kind: "survey", answers: [{ id: "Navigation", answer: 1 }] },
    {
      kind: "run",
      task: 1,
      changed: false,
      bumps: 0,
      mistakes: 0,
      failure: { code: "<b>", line: null },
    },
  ])("rejects %j", (event) => {
    expect(progressSchema.safeParse(event).success).toBe(false);
  });
});
