import { generateTree, parseMaze } from "@corridor/maze";
import { parseProgram, type ProgramDocument } from "@corridor/program";
import { parseRun, type TimedInput } from "@corridor/recording";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { checkOf, digitsOf, textOf } from "./digits.ts";
import { decodeLink, encodeLink, MAX_LINK_LENGTH } from "./link.ts";

const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Turns",
  default: "forward",
  rules: [{ when: { sensor: "front", is: "<", than: 50 }, do: "left 90" }],
};

/** A link whose length and check are right, whatever stands in it: made by hand, not by Corridor. */
function forge(body: readonly number[]): string {
  const length = body.length % 64;
  return `1${textOf([length, ...checkOf(1, [length, ...body]), ...body])}`;
}

describe("a forged link with a right check", () => {
  it("gives legal documents or a refusal, never an error", () => {
    const bodies = fc.oneof(
      fc.array(fc.integer({ min: 0, max: 63 }), { minLength: 1, maxLength: 60 }),
      fc.array(fc.integer({ min: 0, max: 63 }), { minLength: 1, maxLength: 3 }),
      fc.array(fc.constantFrom(0, 1, 62, 63), { minLength: 1, maxLength: 400, size: "max" }),
    );
    const codes = new Set<string>();
    fc.assert(
      fc.property(bodies, (body) => {
        const result = decodeLink(forge(body));
        codes.add(result.ok ? "ok" : result.code);
        const { maze, program } = result.ok ? result.value : {};
        expect(maze === undefined || parseMaze(maze).ok).toBe(true);
        expect(program === undefined || parseProgram(program).ok).toBe(true);
      }),
      { numRuns: 1_000 },
    );
    expect([...codes].filter((code) => code !== "ok").toSorted()).toEqual([
      "damaged",
      "unknown-version",
    ]);
  });

  it("costs no more than the largest document, however long it is", () => {
    for (const digit of [0, 21, 42, 63]) {
      const text = forge(Array.from({ length: MAX_LINK_LENGTH - 6 }, () => digit));
      expect(text).toHaveLength(MAX_LINK_LENGTH);
      expect(decodeLink(text)).toMatchObject({ ok: false });
    }
  });

  it("of a run gives a legal run or a refusal, whatever was changed in it", () => {
    const maze = generateTree({ columns: 9, rows: 9, seed: 1, name: "Tree" });
    const inputs: TimedInput[] = [
      { tick: 10, do: "driver", driver: "me" },
      { tick: 20, do: "command", command: { action: "move", distance: 12.5 }, seq: 4 },
      { tick: 30, do: "program", program: { ...program, default: "stop", rules: [] } },
      { tick: 40, do: "maze", maze: { ...maze, name: "Other" } },
    ];
    const digest = "0123456789abcdef";
    const format = "corridor/run" as const;
    const link = encodeLink({
      run: { format, version: 1, name: "", maze, program, seed: 0, ticks: 50, inputs, digest },
    });
    const body = digitsOf(link.ok ? link.text.slice(6) : "").map((digit) => digit ?? 0);
    expect(decodeLink(forge(body)).ok).toBe(true);
    const change = fc.tuple(fc.nat({ max: body.length - 1 }), fc.integer({ min: 0, max: 63 }));
    let legal = 0;
    fc.assert(
      fc.property(fc.array(change, { minLength: 1, maxLength: 4 }), (changes) => {
        const changed = [...body];
        for (const [at, digit] of changes) changed[at] = digit;
        const result = decodeLink(forge(changed));
        const { run } = result.ok ? result.value : {};
        if (run === undefined) return;
        legal += 1;
        expect(parseRun(run).ok).toBe(true);
      }),
      { numRuns: 1_000 },
    );
    expect(legal).toBeGreaterThan(0);
  });

  it("cannot hide anything behind its documents", () => {
    const link = encodeLink({ maze: generateTree({ columns: 9, rows: 9, seed: 1, name: "Tree" }) });
    expect(link.ok).toBe(true);
    const body = digitsOf(link.ok ? link.text.slice(6) : "").map((digit) => digit ?? 0);
    expect(decodeLink(forge(body)).ok).toBe(true);
    for (const more of [[0], [63], [0, 0, 0], [1, 2, 3, 4, 5, 6, 7, 8]]) {
      expect(decodeLink(forge([...body, ...more]))).toMatchObject({ ok: false, code: "damaged" });
    }
  });
});
