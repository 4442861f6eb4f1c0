import { describe, expect, it } from "vitest";
import { openRun } from "./open-run.ts";
import { Recording } from "./recording.ts";
import type { RunDocument } from "./run-document.ts";
import { MAX_RUN_INPUTS, MAX_RUN_TEXT_LENGTH, MAX_RUN_TICKS } from "./run-limits.ts";
import { parseRun, readRun } from "./run-schema.ts";

const maze = {
  format: "corridor/maze" as const,
  version: 1 as const,
  name: "hall",
  blocks: ["....", "....", "...."],
  start: { column: 0, row: 1, heading: "east" as const },
  goals: [],
};
const program = {
  format: "corridor/program" as const,
  version: 1 as const,
  name: "ahead",
  default: "forward" as const,
  rules: [],
};

function written(): RunDocument {
  const recording = new Recording(maze, program);
  for (let tick = 0; tick < 30; tick++) recording.step();
  recording.addInput({ do: "driver", driver: "me" });
  recording.addInput({ do: "command", command: { action: "left 90" } });
  for (let tick = 0; tick < 30; tick++) recording.step();
  const result = recording.toDocument("a run");
  if (!result.ok) throw new Error(result.reason);
  return result.run;
}

const run = written();
const command = { tick: 10, do: "command", command: { action: "forward" } };

describe("a run document", () => {
  it("is read back from its JSON", () => {
    expect(readRun(JSON.stringify(run))).toEqual({ ok: true, value: run });
  });

  it.each([
    { name: "another format", changes: { format: "corridor/maze" }, path: "format" },
    { name: "a newer version", changes: { version: 2 }, path: "version" },
    { name: "an unknown field", changes: { speed: 2 }, path: "speed" },
    { name: "a seed other than 0", changes: { seed: 7 }, path: "seed" },
    { name: "half a tick", changes: { ticks: 0.5 }, path: "ticks" },
    { name: "more than a day", changes: { ticks: MAX_RUN_TICKS + 1 }, path: "ticks" },
    { name: "a malformed digest", changes: { digest: "abc" }, path: "digest" },
    {
      name: "an unknown character in the maze",
      changes: { maze: { ...maze, blocks: ["....", "..x.", "...."] } },
      path: "maze.blocks[1]",
    },
    {
      name: "an invalid program",
      changes: { program: { ...program, default: "fly" } },
      path: "program.default",
    },
    {
      name: "an unknown kind of input",
      changes: { inputs: [{ tick: 0, do: "jump" }] },
      path: "inputs[0].do",
    },
    {
      name: "an input after the end",
      changes: { inputs: [{ ...command, tick: 61 }] },
      path: "inputs[0].tick",
    },
    {
      name: "inputs out of order",
      changes: { inputs: [command, { ...command, tick: 9 }] },
      path: "inputs[1].tick",
    },
    {
      name: "an invalid command",
      changes: { inputs: [{ ...command, command: { action: "move", distance: "far" } }] },
      path: "inputs[0].command.distance",
    },
    {
      name: "too many inputs",
      changes: {
        inputs: Array.from({ length: MAX_RUN_INPUTS + 1 }, () => ({ tick: 0, do: "cancel" })),
      },
      path: "inputs",
    },
  ])("with $name is rejected with the path of the problem", ({ changes, path }) => {
    const read = readRun(JSON.stringify({ ...run, ...changes }));
    expect(read).toMatchObject({ ok: false, problems: [{ path }] });
  });

  it("over the maximum text length is rejected without parsing", () => {
    const read = readRun(" ".repeat(MAX_RUN_TEXT_LENGTH + 1));
    expect(read).toMatchObject({ ok: false, problems: [{ path: "" }] });
  });
});

it("parsing stops after the maximum number of problems", () => {
  let reads = 0;
  const bad = {
    tick: 0,
    get do() {
      reads++;
      return "fly";
    },
  };
  const read = parseRun({ ...run, inputs: Array.from({ length: 100_000 }, () => bad) });
  expect(read.ok ? 0 : read.problems.length).toBe(20);
  expect(read.ok ? null : read.problems[19]?.path).toBe("inputs[19].do");
  expect(reads).toBeLessThan(1000);
});

describe("a document that matches the schema", () => {
  it.each([
    { name: "another digest", changes: { digest: "0".repeat(16) }, path: "digest" },
    {
      name: "a command while the program drives",
      changes: { inputs: [command] },
      path: "inputs[0]",
    },
    {
      name: "a block at the robot's position",
      changes: {
        inputs: [
          {
            tick: 30,
            do: "maze",
            maze: { ...maze, blocks: ["....", "##..", "...."], start: { ...maze.start, row: 0 } },
          },
        ],
      },
      path: "inputs[0]",
    },
  ])("cannot be opened with $name", ({ changes, path }) => {
    const read = readRun(JSON.stringify({ ...run, ...changes }));
    if (!read.ok) throw new Error(JSON.stringify(read.problems));
    expect(openRun(read.value)).toMatchObject({ ok: false, problems: [{ path }] });
  });
});
