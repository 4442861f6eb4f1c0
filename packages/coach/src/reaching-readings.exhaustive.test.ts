import {
  CompiledProgram,
  programPresets,
  evaluateCondition,
  type ProgramDocument,
} from "@corridor/program";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { ReachingReadings, type ReadingRange } from "./reaching-readings.ts";
import { randomProgram, distinctReadings } from "./testing/random-programs.ts";
import { winningLines } from "./winning-lines.ts";

/** The numbers of random programs lie on both sides of both ends. */
const range: ReadingRange = { min: 11, max: 18 };

/** By brute force: the lines that decide for some reading, and those that are true for some. */
function tried(program: ProgramDocument): { decide: Set<number>; true: Set<number> } {
  const compiled = new CompiledProgram(program);
  const decide = new Set<number>();
  const isTrue = new Set<number>();
  for (const readings of distinctReadings(program, range)) {
    const { front, right, back, left } = readings;
    const line = compiled.decide(Float64Array.of(front, right, back, left));
    decide.add(line === -1 ? program.rules.length : line);
    for (const [index, { when }] of program.rules.entries()) {
      if (evaluateCondition(when, readings)?.isTrue === true) isTrue.add(index);
    }
  }
  return { decide, true: isTrue };
}

/** The lines that can decide, `rules.length` for "otherwise". */
function reasoned({ rules }: ProgramDocument): Set<number> {
  const reaching = new ReachingReadings(range);
  const decide = new Set<number>();
  for (const [line, { when }] of rules.entries()) {
    if (when === null) continue;
    if (reaching.allows(when)) decide.add(line);
    reaching.pass(when);
  }
  if (!reaching.isEmpty) decide.add(rules.length);
  return decide;
}

/** A program in which only these lines have conditions. */
function only(program: ProgramDocument, lines: readonly number[]): ProgramDocument {
  const rules = program.rules.map((rule, at) =>
    lines.includes(at) ? rule : { ...rule, when: null },
  );
  return { ...program, rules };
}

describe("which lines can decide", () => {
  it("is the same as with brute force, for any program", () => {
    fc.assert(
      fc.property(randomProgram(8), (program) => {
        const { decide } = tried(program);
        expect([...reasoned(program)].toSorted((a, b) => a - b)).toEqual(
          [...decide].toSorted((a, b) => a - b),
        );
      }),
      { numRuns: 2000 },
    );
  });

  it("varies enough for the property to be meaningful", () => {
    let some = 0;
    let all = 0;
    for (const program of fc.sample(randomProgram(8), { numRuns: 500, seed: 7 })) {
      const lines = program.rules.filter(({ when }) => when !== null).length + 1;
      if (reasoned(program).size < lines) some++;
      else all++;
    }
    expect(some).toBeGreaterThan(50);
    expect(all).toBeGreaterThan(50);
  });
});

describe("the lines that win", () => {
  it("exist if and only if a line never decides, and are none if its condition is never true", () => {
    fc.assert(
      fc.property(randomProgram(8), (program) => {
        const { decide, true: isTrue } = tried(program);
        for (const [line, { when }] of program.rules.entries()) {
          if (when === null) continue;
          const winners = winningLines(program.rules, line, range);
          expect(winners === null).toBe(decide.has(line));
          expect(winners?.length === 0).toBe(!isTrue.has(line));
        }
        const winners = winningLines(program.rules, program.rules.length, range);
        expect(winners === null).toBe(decide.has(program.rules.length));
      }),
      { numRuns: 1000 },
    );
  });

  it("are sufficient, and no smaller set is", () => {
    fc.assert(
      fc.property(randomProgram(6), (program) => {
        for (let line = 0; line <= program.rules.length; line++) {
          const own = program.rules[line];
          if (own?.when === null) continue;
          const winners = winningLines(program.rules, line, range);
          if (winners === null) continue;
          const decides = (lines: readonly number[]) =>
            tried(only(program, [...lines, line])).decide.has(line);
          expect(decides(winners)).toBe(false);
          for (const fewer of subsets(line, winners.length - 1)) expect(decides(fewer)).toBe(true);
        }
      }),
      { numRuns: 200 },
    );
  });

  it("are the uppermost sufficient ones", () => {
    const front = (than: number) => ({
      when: { sensor: "front" as const, is: ">" as const, than },
      do: "forward" as const,
    });
    expect(winningLines([front(17), front(14), front(12), front(15)], 3, range)).toEqual([1]);
  });

  it.each([
    ["front > 50 and front < 60", ["front > 50", "front < 60"], "otherwise", [0, 1]],
    ["a wider line above", ["left > right + 10"], "left > right + 20", [0]],
    ["the same line twice", ["right > 60", "front < 50"], "right > 60", [0]],
    ["two sides that bound the third", ["right > 100", "left > right + 10"], "left > 110", [0, 1]],
    ["a line that is always true", ["front < 50", "back > 20"], "left > 60", [1]],
    [
      "three lines that take all there is",
      ["right > 100", "left < 150", "left > right + 20"],
      "otherwise",
      [0, 1, 2],
    ],
  ])("are found behind %s", (_, above, line, winners) => {
    const rules = above.map(parse);
    const all = line === "otherwise" ? rules : [...rules, parse(line)];
    expect(winningLines(all, above.length, { min: 24.5, max: 1000 })).toEqual(winners);
  });

  it.each(programPresets)("do not exist in $id", ({ program }) => {
    const lines = program.rules.map((_, line) =>
      winningLines(program.rules, line, { min: 24.5, max: 1000 }),
    );
    expect(lines.every((winners) => winners === null)).toBe(true);
  });
});

/** "front > 50" or "left > right + 10", going forward. */
function parse(text: string): ProgramDocument["rules"][number] {
  const [sensor = "", is = "", first = "", , plus] = text.split(" ");
  const when =
    first === "right"
      ? { sensor, is, than: first, plus: Number(plus) }
      : { sensor, is, than: Number(first) };
  return { when: when as ProgramDocument["rules"][number]["when"], do: "forward" };
}

/** All sets of `size` of the first `count` lines. */
function subsets(count: number, size: number): number[][] {
  if (size <= 0) return size === 0 ? [[]] : [];
  return Array.from({ length: count }, (_, last) => last).flatMap((last) =>
    subsets(last, size - 1).map((rest) => [...rest, last]),
  );
}
