import { generateTree, mazePresets, type MazeDocument } from "@corridor/maze";
import { arbitraryMaze } from "@corridor/maze/testing";
import { programPresets, type ProgramDocument } from "@corridor/program";
import { arbitraryProgram, paperPrograms } from "@corridor/program/testing";
import fc from "fast-check";
import { MAX_LINK_LENGTH } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { decodeLink, encodeLink, type DecodeResult } from "./link.ts";
import type { LinkContent } from "./link-body.ts";
import { goldenLinks } from "./testing/golden-links.ts";
import { bushyTree, drawnMaze, randomMaze } from "./testing/sample-mazes.ts";

const ALPHABET = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_".split("");

const rightWall: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Right wall",
  default: "forward",
  rules: [
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
    { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
  ],
};

function linkOf(content: LinkContent): string {
  const link = encodeLink(content);
  if (!link.ok) throw new Error(`no link: ${link.code}`);
  return link.text;
}

function valueOf(result: DecodeResult): LinkContent | null {
  return result.ok ? result.value : null;
}

const anyContent: fc.Arbitrary<LinkContent> = fc.oneof(
  fc.record({ maze: arbitraryMaze }),
  fc.record({ program: arbitraryProgram }),
  fc.record({ maze: arbitraryMaze, program: arbitraryProgram }),
);

describe("a link", () => {
  it("decodes to equal documents, or is refused as too big", () => {
    fc.assert(
      fc.property(anyContent, (content) => {
        const link = encodeLink(content);
        const isTooBig = !link.ok && link.code === "too-big";
        const cells = content.maze?.blocks.join("").length ?? 0;
        expect(isTooBig && cells < 40_000).toBe(false);
        const text = link.ok ? link.text : "";
        expect(text).toMatch(isTooBig ? /^$/ : /^[A-Za-z0-9_-]+$/);
        expect(isTooBig ? content : valueOf(decodeLink(text))).toEqual(content);
      }),
      { numRuns: 300 },
    );
  });

  it.each(["", "\0", "a\u007fb", "🤖 robot", "\ud800 half", "迷路", "Übung 1", "x".repeat(100)])(
    "retains the name %j",
    (name) => {
      const maze = { ...generateTree({ columns: 5, rows: 5, seed: 1, name }) };
      expect(decodeLink(linkOf({ maze }))).toEqual({ ok: true, value: { maze } });
    },
  );

  it.each([0, -0, 0.1, -0.1, 1e-300, 60, 100_000, -100_000, 99_999.999, 5e-324])(
    "retains the number %d",
    (plus) => {
      const program = {
        ...rightWall,
        rules: [
          { when: { sensor: "left", is: ">", than: "right", plus } as const, do: "stop" as const },
        ],
      };
      expect(decodeLink(linkOf({ program }))).toEqual({ ok: true, value: { program } });
    },
  );

  it("retains every preset and every program of the thesis, in at most 60 characters", () => {
    const contents: LinkContent[] = [
      ...mazePresets.map(({ maze }) => ({ maze })),
      ...programPresets.map(({ program }) => ({ program })),
      ...paperPrograms.map(({ program }) => ({ program })),
    ];
    for (const content of contents) {
      const text = linkOf(content);
      expect(decodeLink(text)).toEqual({ ok: true, value: content });
      expect(text.length).toBeLessThanOrEqual(60);
    }
  });

  it("of a maze too large for a link is refused as too big", () => {
    const huge = randomMaze("", 256, 50, false, 1);
    expect(encodeLink({ maze: huge })).toMatchObject({ ok: false, code: "too-big" });
    expect(linkOf({ maze: randomMaze("", 256, 20, false, 1) }).length).toBeLessThanOrEqual(
      MAX_LINK_LENGTH,
    );
  });

  it("always fits a maze of 160 x 160 cells with the longest name, goals and program", () => {
    const side = 160;
    const name = "\ud800\uffff迷".repeat(33);
    const maze = randomMaze(name, side, 50, false, 1);
    const isOpen = (cell: number) => maze.blocks[cell % side]?.[Math.floor(cell / side)] === ".";
    const cells = Array.from({ length: side * side }, (_, at) => (at * 997) % (side * side));
    const goals = cells
      .filter(isOpen)
      .slice(0, 256)
      .map((cell) => ({ column: Math.floor(cell / side), row: cell % side }));
    const rule = (at: number) => ({
      when: { sensor: "left", is: ">", than: "right", plus: Math.SQRT2 * (at - 99.5) } as const,
      do: at % 3 === 0 ? ("stop" as const) : ("left 90" as const),
    });
    const rules = Array.from({ length: 200 }, (_, at) => rule(at));
    const content = { maze: { ...maze, goals }, program: { ...rightWall, name, rules } };
    expect(goals).toHaveLength(256);
    expect(decodeLink(linkOf(content))).toEqual({ ok: true, value: content });
  });

  it("without content is refused as empty", () => {
    expect(encodeLink({})).toMatchObject({ ok: false, code: "empty" });
  });
});

describe("the length of a link for a 33 x 33 maze", () => {
  const name20 = "Zx9#kQ2~pL0{vB7^wM4@";
  const seeds = Array.from({ length: 20 }, (_, at) => at + 1);
  it.each<[string, number, (seed: number) => MazeDocument]>([
    ["generated", 80, (seed) => generateTree({ columns: 33, rows: 33, seed, name: "Tree" })],
    ["perfect, by Kruskal", 85, (seed) => bushyTree("Tree", 33, seed)],
    ["drawn", 100, (seed) => drawnMaze("Drawn", 33, seed)],
    ["random 30 % with a border", 166, (seed) => randomMaze("Random", 33, 30, true, seed)],
    [
      "random 50 % with a border and a random name of 20",
      200,
      (seed) => randomMaze(name20, 33, 50, true, seed),
    ],
    ["random 30 %, open to its edges", 185, (seed) => randomMaze("Random", 33, 30, false, seed)],
    ["random 50 %, open to its edges", 200, (seed) => randomMaze("Maze", 33, 50, false, seed)],
  ])("%s: at most %i characters", (_, maxLength, create) => {
    const lengths = seeds.map((seed) => linkOf({ maze: create(seed) }).length);
    expect(Math.max(...lengths)).toBeLessThanOrEqual(maxLength);
  });

  it("random 30 % with a border: at most 160 on average", () => {
    const lengths = seeds.map(
      (seed) => linkOf({ maze: randomMaze("Maze", 33, 30, true, seed) }).length,
    );
    expect(lengths.reduce((sum, length) => sum + length) / lengths.length).toBeLessThanOrEqual(160);
  });
});

describe("published links", () => {
  it.each(goldenLinks)("stay readable: $name", ({ text, content }) => {
    expect(decodeLink(text)).toEqual({ ok: true, value: content });
  });

  it.each(goldenLinks)("are encoded to the same text: $name", ({ text, content }) => {
    const read = decodeLink(text);
    expect(read.ok && linkOf(read.value)).toBe(text);
    expect(read.ok && read.value).toEqual(content);
  });
});

describe("a damaged link", () => {
  const text = linkOf({
    maze: generateTree({ columns: 21, rows: 21, seed: 5, name: "Class 7" }),
    program: rightWall,
  });

  it("is rejected for each change of one character", () => {
    for (let at = 0; at < text.length; at += 1) {
      for (const character of ALPHABET) {
        if (character === text[at]) continue;
        const changed = text.slice(0, at) + character + text.slice(at + 1);
        expect(decodeLink(changed).ok ? changed : null).toBeNull();
      }
    }
  });

  it("is rejected for each lost, doubled or swapped character, and for each truncation", () => {
    for (let at = 0; at < text.length; at += 1) {
      const lost = text.slice(0, at) + text.slice(at + 1);
      const doubled = text.slice(0, at + 1) + text.slice(at);
      expect([lost, doubled].map((each) => decodeLink(each).ok)).toEqual([false, false]);
      const swapped =
        text.slice(0, at) + (text[at + 1] ?? "") + (text[at] ?? "") + text.slice(at + 2);
      expect(decodeLink(swapped).ok).toBe(swapped === text);
      expect(decodeLink(text.slice(0, at)).ok).toBe(false);
    }
    for (const cut of [1, 2, 3, 10, 30]) {
      expect(decodeLink(text.slice(0, -cut))).toMatchObject({ ok: false, code: "cut-off" });
    }
  });

  it("is rejected after any number of random changes", () => {
    const change = fc.record({
      at: fc.nat(),
      character: fc.constantFrom(...ALPHABET, ".", "%", " "),
    });
    fc.assert(
      fc.property(fc.array(change, { minLength: 1, maxLength: 6 }), (changes) => {
        let changed = text;
        for (const { at, character } of changes) {
          const index = at % changed.length;
          changed = changed.slice(0, index) + character + changed.slice(index + 1);
        }
        expect(decodeLink(changed).ok).toBe(changed === text);
      }),
      { numRuns: 3_000 },
    );
  });
});

describe("any text in place of a link", () => {
  it("is rejected with a problem, without an exception", () => {
    const anyText = fc.oneof(
      fc.string({ unit: "binary" }),
      fc.string({ unit: fc.constantFrom(...ALPHABET), maxLength: 300 }),
      fc.string({ unit: fc.constantFrom(...ALPHABET), maxLength: 300 }).map((body) => `1${body}`),
    );
    fc.assert(
      fc.property(anyText, (text) => {
        const result = decodeLink(text);
        expect(result).toMatchObject({ ok: false, problems: [{ path: "link" }] });
      }),
      { numRuns: 3_000 },
    );
  });
});
