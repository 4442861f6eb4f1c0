import { parseLesson, type LessonDocument, type LessonTask } from "@corridor/challenge";
import { generateTree, parseMaze, type MazeDocument } from "@corridor/maze";
import { parseProgram, type ProgramDocument } from "@corridor/program";
import { parseRun, type RunDocument, type RunInput, type TimedInput } from "@corridor/recording";
import fc from "fast-check";
import { MAX_LINK_LENGTH } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { checkOf, digitsOf, textOf } from "./digits.ts";
import { noChoices, type Choices } from "./choices.ts";
import { codeLesson } from "./lesson-coder.ts";
import { decodeLink, encodeLink } from "./link.ts";
import type { LinkContent } from "./link-body.ts";
import { codeUniform } from "./numbers.ts";
import { placeholderLesson, placeholderRun, placeholderTask } from "./placeholders.ts";
import { Decoder, Encoder, type BitCoder } from "./range-coder.ts";
import { codeRun } from "./run-coder.ts";
import { shortest } from "./shortest-encoding.ts";

const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Turns",
  default: "forward",
  rules: [{ when: { sensor: "front", is: "<", than: 50 }, do: "left 90" }],
};

/** Creates a link with a valid length and checksum from any digits. */
function forge(body: readonly number[]): string {
  const length = body.length % 64;
  return `1${textOf([length, ...checkOf(1, [length, ...body]), ...body])}`;
}

const choices: Choices = { ...shortest, isPlainName: () => true };

/** The digits of a run's link, without the length limit of an encoder. */
function forgeRun(run: RunDocument): readonly number[] {
  const encoder = new Encoder();
  codeSection(encoder, RUN);
  codeRun(encoder, run, choices, Infinity);
  return encoder.finish();
}

/** Number of bits that a decoder reads. @param read decodes the documents after the header */
function bitsReadOf(digits: readonly number[], section: number, read: (coder: BitCoder) => void) {
  const decoder = new Decoder(digits);
  let count = 0;
  const counting: BitCoder = {
    bit: (zeros, ones) => {
      count += 1;
      return decoder.bit(zeros, ones);
    },
  };
  codeSection(counting, section);
  read(counting);
  return count;
}

const readRunBits = (digits: readonly number[]): number =>
  bitsReadOf(digits, RUN, (coder) => codeRun(coder, placeholderRun, noChoices));

const RUN = 0;
const LESSON = 2;

/** Codes an extended header without maze and program, and the number of a section. */
function codeSection(coder: BitCoder, section: number): void {
  coder.bit(31, 1, 1);
  coder.bit(1, 3, 0);
  coder.bit(1, 1, 0);
  codeUniform(coder, 16, section);
}

const runHead = {
  format: "corridor/run" as const,
  version: 1 as const,
  name: "",
  seed: 0,
  digest: "0123456789abcdef",
};

describe("a forged link with a valid checksum", () => {
  it("decodes to valid documents or is rejected, without an exception", () => {
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

  it("is rejected at the maximum length", () => {
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
    { of: "manual commands", input: { do: "command", command: { action: "stop" } } },
    { of: "cancellations", input: { do: "cancel" } },
  ])(
    "with many inputs of $of is limited to 256 KiB and to the bits of the largest run",
    ({ input }) => {
      const runOf = (count: number): RunDocument => ({
        ...runHead,
        maze: hall,
        program: longest,
        ticks: 5_184_000,
        inputs: Array.from({ length: count }, () => ({ tick: 1, ...input })),
      });
      // The maximum number of inputs that the encoder accepts.
      let [maxCount, tooMany] = [0, 100_000];
      while (tooMany - maxCount > 1) {
        const middle = (maxCount + tooMany) >> 1;
        if (encodeLink({ run: runOf(middle) }).ok) maxCount = middle;
        else tooMany = middle;
      }
      const largest = encodeLink({ run: runOf(maxCount) });
      const read = decodeLink(largest.ok ? largest.text : "");
      const run = read.ok ? read.value.run : undefined;
      expect(run?.inputs).toHaveLength(maxCount);
      expect(JSON.stringify(run?.inputs).length).toBeLessThanOrEqual(256 * 1024);
      // The decoder rejects a larger run before it has built all of it.
      const forged = forgeRun(runOf(20 * maxCount));
      expect(decodeLink(forge(forged))).toMatchObject({ ok: false, code: "damaged" });
      // The larger number of inputs itself needs a few more bits.
      expect(readRunBits(forged)).toBeLessThanOrEqual(
        readRunBits(forgeRun(runOf(maxCount + 1))) + 40,
      );
    },
  );

  it("of a run decodes to a valid run or is rejected after any changes", () => {
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
    let valid = 0;
    fc.assert(
      fc.property(fc.array(change, { minLength: 1, maxLength: 4 }), (changes) => {
        const changed = [...body];
        for (const [at, digit] of changes) changed[at] = digit;
        const result = decodeLink(forge(changed));
        const { run } = result.ok ? result.value : {};
        if (run === undefined) return;
        valid += 1;
        expect(parseRun(run).ok).toBe(true);
      }),
      { numRuns: 1_000 },
    );
    expect(valid).toBeGreaterThan(0);
  });

  const lesson: LessonDocument = {
    ...placeholderLesson,
    name: "Lesson",
    tasks: ["One", "Two"].map((name, at) => taskOf(name, [smallMaze(at), smallMaze(at + 1)])),
  };
  const drive = [
    { tick: 3, command: { action: "forward" as const } },
    { tick: 90, command: { action: "drive" as const, left: 0.5, right: -0.25, milliseconds: 400 } },
  ];
  it.each<{ of: string; content: LinkContent }>([
    { of: "a lesson", content: { lesson } },
    { of: "a lesson with a program", content: { lesson, program } },
    {
      of: "a completion code",
      content: { completion: { lesson: "0a1b2c3d4", task: 3, attempt: program } },
    },
    {
      of: "a manual drive",
      content: { completion: { lesson: "0a1b2c3d4", task: 3, attempt: drive } },
    },
  ])("of $of decodes to valid documents or is rejected after any changes", ({ content }) => {
    const link = encodeLink(content);
    const body = digitsOf(link.ok ? link.text.slice(6) : "").map((digit) => digit ?? 0);
    expect(decodeLink(forge(body)).ok).toBe(true);
    // Changes of the last digits are the most likely ones to leave the link valid.
    const anyPlace = fc.oneof(fc.nat({ max: body.length - 1 }), fc.constant(body.length - 1));
    const change = fc.tuple(anyPlace, fc.integer({ min: 0, max: 63 }));
    let valid = 0;
    fc.assert(
      fc.property(fc.array(change, { minLength: 1, maxLength: 4 }), (changes) => {
        const changed = [...body];
        for (const [at, digit] of changes) changed[at] = digit;
        const result = decodeLink(forge(changed));
        if (!result.ok) return;
        valid += 1;
        const { completion } = result.value;
        expect(result.value.lesson === undefined || parseLesson(result.value.lesson).ok).toBe(true);
        if (completion === undefined) return;
        expect(completion.lesson).toMatch(/^[0-9a-f]{9}$/);
        expect(completion.task).toBeLessThan(12);
        const { attempt } = completion;
        expect("rules" in attempt ? parseProgram(attempt).ok : attempt.length > 0).toBe(true);
      }),
      { numRuns: 1_000 },
    );
    expect(valid).toBeGreaterThan(0);
  });

  it("with very many large mazes is limited to the size of a file", () => {
    const hall = { ...smallMaze(1), blocks: Array.from({ length: 256 }, () => ".".repeat(256)) };
    const halls = Array.from({ length: 12 }, (_, task) =>
      taskOf(
        "",
        Array.from({ length: 10 }, (__, at) => ({ ...hall, goals: [{ column: at, row: task }] })),
      ),
    );
    const encoder = new Encoder();
    codeSection(encoder, LESSON);
    expect(codeLesson(encoder, { ...placeholderLesson, tasks: halls }, choices)).toBeNull();
    const digits = encoder.finish();
    expect(decodeLink(forge(digits))).toMatchObject({ ok: false, code: "damaged" });
    const bits = bitsReadOf(digits, LESSON, (coder) =>
      codeLesson(coder, placeholderLesson, noChoices),
    );
    // About one bit for each cell.
    expect(bits).toBeLessThan(2.3 * 1024 * 1024);
  });

  it("is rejected with extra digits after its documents", () => {
    const link = encodeLink({ maze: generateTree({ columns: 9, rows: 9, seed: 1, name: "Tree" }) });
    expect(link.ok).toBe(true);
    const body = digitsOf(link.ok ? link.text.slice(6) : "").map((digit) => digit ?? 0);
    expect(decodeLink(forge(body)).ok).toBe(true);
    for (const more of [[0], [63], [0, 0, 0], [1, 2, 3, 4, 5, 6, 7, 8]]) {
      expect(decodeLink(forge([...body, ...more]))).toMatchObject({ ok: false, code: "damaged" });
    }
  });
});

function smallMaze(seed: number): MazeDocument {
  const maze = generateTree({ columns: 9, rows: 9, seed, name: `Maze ${seed}` });
  return { ...maze, goals: [{ column: 7, row: 7 }] };
}

function taskOf(name: string, mazes: MazeDocument[]): LessonTask {
  const allowed = { ...placeholderTask.allowed, drivers: ["program" as const], lines: 3 };
  const unseen = { kind: "tree" as const, columns: 9, rows: 9, seed: 4, count: 50, pass: 45 };
  return { ...placeholderTask, name, mazes, allowed, unseen };
}
