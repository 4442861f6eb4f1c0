import { generateTree, parseMaze } from "@corridor/maze";
import { parseProgram, type ProgramDocument } from "@corridor/program";
import { parseRun, type RunDocument, type RunInput, type TimedInput } from "@corridor/recording";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { checkOf, digitsOf, textOf } from "./digits.ts";
import type { Choices } from "./edit-coder.ts";
import { decodeLink, encodeLink, MAX_LINK_LENGTH } from "./link.ts";
import { codeUniform } from "./numbers.ts";
import { Decoder, Encoder, type BitCoder } from "./range-coder.ts";
import { codeRun } from "./run-coder.ts";
import { shortestBlockWay } from "./shortest-way.ts";

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

const choices: Choices = {
  waysOf: (each) => ({ blocks: shortestBlockWay(each), isPlainName: true }),
  isPlainName: () => true,
};

/** The digits of a run's link, however much it brings. */
function forgeRun(run: RunDocument): readonly number[] {
  const encoder = new Encoder();
  codeRunHead(encoder);
  codeRun(encoder, run, choices, Infinity);
  return encoder.finish();
}

/** As many bits as a reader takes from it. */
function bitsReadOf(digits: readonly number[]): number {
  const decoder = new Decoder(digits);
  let count = 0;
  const counting: BitCoder = {
    bit: (zeros, ones) => {
      count += 1;
      return decoder.bit(zeros, ones);
    },
  };
  codeRunHead(counting);
  const any = { maze: generateTree({ columns: 9, rows: 9, seed: 1, name: "" }), program };
  codeRun(counting, { ...runHead, ...any, ticks: 0, inputs: [] }, choices);
  return count;
}

/** There is more, no maze, no program, and the section of runs. */
function codeRunHead(coder: BitCoder): void {
  coder.bit(31, 1, 1);
  coder.bit(1, 3, 0);
  coder.bit(1, 1, 0);
  codeUniform(coder, 16, 0);
}

const runHead = {
  format: "corridor/run" as const,
  version: 1 as const,
  name: "",
  seed: 0,
  digest: "0123456789abcdef",
};

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

  it("is refused, however long it is", () => {
    for (const digit of [0, 21, 42, 63]) {
      const text = forge(Array.from({ length: MAX_LINK_LENGTH - 6 }, () => digit));
      expect(text).toHaveLength(MAX_LINK_LENGTH);
      expect(decodeLink(text)).toMatchObject({ ok: false });
    }
  });

  const longest: ProgramDocument = {
    ...program,
    rules: Array.from({ length: 199 }, () => ({ when: null, do: "left 90" })),
  };
  const hall = { ...generateTree({ columns: 101, rows: 101, seed: 1, name: "" }), goals: [] };
  it.each<{ of: string; input: RunInput }>([
    { of: "a long program", input: { do: "program", program: longest } },
    { of: "a short program", input: { do: "program", program: { ...longest, rules: [] } } },
    { of: "a large maze", input: { do: "maze", maze: hall } },
    { of: "a hand's commands", input: { do: "command", command: { action: "stop" } } },
    { of: "what cancels", input: { do: "cancel" } },
  ])("of many edits of $of brings no more than 256 KiB, and takes no longer", ({ input }) => {
    const runOf = (count: number): RunDocument => ({
      ...runHead,
      maze: hall,
      program: longest,
      ticks: 5_184_000,
      inputs: Array.from({ length: count }, () => ({ tick: 1, ...input })),
    });
    // The costliest that Corridor writes, and reads.
    let [most, more] = [0, 100_000];
    while (more - most > 1) {
      const middle = (most + more) >> 1;
      if (encodeLink({ run: runOf(middle) }).ok) most = middle;
      else more = middle;
    }
    const costliest = encodeLink({ run: runOf(most) });
    const read = decodeLink(costliest.ok ? costliest.text : "");
    const run = read.ok ? read.value.run : undefined;
    expect(run?.inputs).toHaveLength(most);
    expect(JSON.stringify(run?.inputs).length).toBeLessThanOrEqual(256 * 1024);
    // What it refuses to write is refused by its reader too, before all of it is built.
    const forged = forgeRun(runOf(20 * most));
    expect(decodeLink(forge(forged))).toMatchObject({ ok: false, code: "damaged" });
    // The number of edits itself takes a few bits more.
    expect(bitsReadOf(forged)).toBeLessThanOrEqual(bitsReadOf(forgeRun(runOf(most + 1))) + 40);
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
