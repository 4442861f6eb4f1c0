import { generateTree, parseMaze } from "@corridor/maze";
import { parseProgram } from "@corridor/program";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { checkOf, digitsOf, textOf } from "./digits.ts";
import { decodeLink, encodeLink, MAX_LINK_LENGTH } from "./link.ts";

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
