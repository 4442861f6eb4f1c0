import { generateTree, isBlock, setBlock, type MazeDocument } from "@corridor/maze";
import { arbitraryMaze } from "@corridor/maze/testing";
import { programPresets, type ProgramDocument } from "@corridor/program";
import { arbitraryProgram } from "@corridor/program/testing";
import { MAX_LINK_LENGTH, plainActions, type Command } from "@corridor/protocol";
import type { RunDocument, RunInput, TimedInput } from "@corridor/recording";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { decodeLink, encodeLink } from "./link.ts";

const rightWall = programPresets.find(({ id }) => id === "right-wall")?.program as ProgramDocument;
const tree = generateTree({ columns: 11, rows: 7, seed: 3, name: "Tree" });

function runOf(inputs: TimedInput[], changes: Partial<RunDocument> = {}): RunDocument {
  return {
    format: "corridor/run",
    version: 1,
    name: "Tree",
    maze: tree,
    program: rightWall,
    seed: 0,
    ticks: 3_600,
    inputs,
    digest: "0123456789abcdef",
    ...changes,
  };
}

/** Encodes a run and checks that the link decodes to an equal run. */
function textOf(run: RunDocument): string {
  const link = encodeLink({ run });
  if (!link.ok) throw new Error(`no link: ${link.code}`);
  expect(decodeLink(link.text)).toEqual({ ok: true, value: { run } });
  return link.text;
}

const anyAmount = fc.oneof(
  fc.integer({ min: -1_000, max: 1_000 }),
  fc.double({ min: -1_000, max: 1_000, noNaN: true }),
);
const anyPower = fc.double({ min: -1, max: 1, noNaN: true });
const anyCommand: fc.Arbitrary<Command> = fc.oneof(
  fc.record({ action: fc.constantFrom(...plainActions) }),
  fc.record({ action: fc.constant("move" as const), distance: anyAmount }),
  fc.record({ action: fc.constant("turn" as const), degrees: anyAmount }),
  fc.record(
    {
      action: fc.constant("drive" as const),
      left: anyPower,
      right: anyPower,
      milliseconds: fc.integer({ min: 1, max: 60_000 }),
    },
    { requiredKeys: ["action", "left", "right"] },
  ),
);
const anyInput: fc.Arbitrary<RunInput> = fc.oneof(
  fc.record({
    do: fc.constant("driver" as const),
    driver: fc.constantFrom("me" as const, "program" as const, "remote" as const),
  }),
  fc.record(
    {
      do: fc.constant("command" as const),
      command: anyCommand,
      seq: fc.integer({ min: 1, max: Number.MAX_SAFE_INTEGER }),
    },
    { requiredKeys: ["do", "command"] },
  ),
  fc.record({ do: fc.constant("cancel" as const) }),
  fc.record({ do: fc.constant("program" as const), program: arbitraryProgram }),
  fc.record({ do: fc.constant("maze" as const), maze: arbitraryMaze }),
);
const anyTick = fc.oneof(fc.integer({ min: 0, max: 600 }), fc.integer({ min: 0, max: 5_184_000 }));
const anyRun: fc.Arbitrary<RunDocument> = fc
  .record({
    name: fc.string({ unit: "binary", maxLength: 50 }),
    maze: arbitraryMaze,
    program: arbitraryProgram,
    digest: fc.bigInt(0n, 2n ** 64n - 1n).map((bits) => bits.toString(16).padStart(16, "0")),
    inputs: fc.array(fc.tuple(anyTick, anyInput), { maxLength: 20 }),
    more: anyTick,
  })
  .map(({ inputs, more, ...rest }) => {
    const timed = inputs
      .map(([tick, input]): TimedInput => ({ tick, ...input }))
      .toSorted((a, b) => a.tick - b.tick);
    return runOf(timed, { ...rest, ticks: Math.max(more, timed.at(-1)?.tick ?? 0) });
  });

describe("the link of a run", () => {
  it("decodes to an equal run, or is refused as too big", () => {
    let fitting = 0;
    fc.assert(
      fc.property(anyRun, (run) => {
        const link = encodeLink({ run });
        if (link.ok) fitting += 1;
        const read = link.ok ? decodeLink(link.text) : null;
        expect(read).toEqual(link.ok ? { ok: true, value: { run } } : null);
        expect(link).toMatchObject(link.ok ? {} : { code: "too-big" });
      }),
      { numRuns: 150 },
    );
    expect(fitting).toBeGreaterThan(30);
  });

  it("is at most 24 characters longer than maze and program, for any length of the run", () => {
    const maze = encodeLink({ maze: tree, program: rightWall });
    const length = maze.ok ? maze.text.length : 0;
    expect(textOf(runOf([])).length).toBeLessThanOrEqual(length + 20);
    expect(textOf(runOf([], { ticks: 5_184_000 })).length).toBeLessThanOrEqual(length + 24);
  });

  it("is a few characters longer for each key press, changed number and block", () => {
    const plain = textOf(runOf([])).length;
    const drive = Array.from({ length: 100 }, (_, at): TimedInput => ({
      tick: 37 * at,
      do: "command",
      command: { action: at % 2 === 0 ? "forward" : "stop" },
    }));
    expect(textOf(runOf(drive, { ticks: 4_000 })).length - plain).toBeLessThanOrEqual(250);
    const rules = rightWall.rules.with(0, {
      when: { sensor: "right", is: ">", than: 61 },
      do: "right 90",
    });
    const program = { ...rightWall, rules };
    const edited = textOf(runOf([{ tick: 900, do: "program", program }])).length;
    expect(edited - plain).toBeLessThanOrEqual(12);
    const maze = blockedMaze(tree);
    const blocked = textOf(runOf([{ tick: 900, do: "maze", maze }])).length;
    expect(blocked - plain).toBeLessThanOrEqual(8);
  });

  it("is refused as too big for a long run", () => {
    const commands = Array.from({ length: 20_000 }, (_, at): TimedInput => ({
      tick: at * 7 + ((at * at) % 5),
      do: "command",
      command: { action: plainActions[(at * 13) % 8] ?? "stop" },
    }));
    const run = runOf(commands, { ticks: 200_000 });
    expect(encodeLink({ run })).toMatchObject({ ok: false, code: "too-big" });
  });

  it("is refused as too big for many edits of a large maze", () => {
    // Each edit needs one or two bits and decodes to a maze of 65,536 cells.
    const maze: MazeDocument = {
      ...tree,
      blocks: Array.from({ length: 256 }, () => ".".repeat(256)),
    };
    const inputs = Array.from({ length: 100 }, (_, tick): TimedInput => ({
      tick,
      do: "maze",
      maze,
    }));
    const run = runOf(inputs, { maze });
    expect(encodeLink({ run })).toMatchObject({ ok: false, code: "too-big" });
    const fewer = textOf(runOf(inputs.slice(0, 2), { maze }));
    expect(fewer.length).toBeLessThan(MAX_LINK_LENGTH / 8);
  });
});

/** Returns the maze with one cell toggled. */
function blockedMaze(maze: MazeDocument): MazeDocument {
  const edit = setBlock(maze, { column: 5, row: 3 }, !isBlock(maze, 5, 3));
  if (!edit.ok) throw new Error(edit.code);
  return edit.maze;
}
