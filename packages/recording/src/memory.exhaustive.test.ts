import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { Recording } from "./recording.ts";

const HOUR = 216_000;
const MAX_BYTES = 16 * 1024 * 1024;

const hall: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "hall",
  blocks: Array.from({ length: 9 }, () => ".".repeat(9)),
  start: { column: 4, row: 4, heading: "east" },
  goals: [],
};

function program(rules: ProgramDocument["rules"], otherwise: ProgramDocument["default"]) {
  const format = "corridor/program" as const;
  return { format, version: 1 as const, name: "any", default: otherwise, rules };
}

const driving: {
  name: string;
  program: ProgramDocument;
  start?: (recording: Recording) => void;
}[] = [
  {
    name: "a program that reverses its direction on every tick",
    program: program([{ when: { sensor: "front", is: "<", than: 400 }, do: "reverse" }], "forward"),
  },
  {
    name: "a program that bumps and turns",
    program: program([{ when: { sensor: "front", is: "<", than: 30 }, do: "right 90" }], "forward"),
  },
  {
    name: "a script that drives in arcs",
    program: program([], "stop"),
    start: (recording) => {
      recording.addInput({ do: "driver", driver: "remote" });
      const command = { action: "drive" as const, left: 0.5, right: 0.3 };
      recording.addInput({ do: "command", command, seq: 1 });
    },
  },
  {
    name: "a user who presses a key every tenth of a second",
    program: program([], "stop"),
    start: (recording) => void recording.addInput({ do: "driver", driver: "me" }),
  },
];

describe("a recording of an hour", () => {
  it.each(driving)("uses less than 16 MB: $name", ({ name, program: driver, start }) => {
    const recording = new Recording(hall, driver);
    start?.(recording);
    for (let tick = 0; tick < HOUR; tick++) {
      if (name.startsWith("a user") && tick % 6 === 0) {
        const action = tick % 12 === 0 ? ("forward" as const) : ("reverse" as const);
        recording.addInput({ do: "command", command: { action } });
      }
      recording.step();
    }
    expect(recording.run.tick).toBe(HOUR);
    expect(recording.byteLength).toBeLessThan(MAX_BYTES);
    // The timeline covers the whole hour.
    const { timeline } = recording;
    expect(timeline.tickOf(0)).toBe(0);
    expect(timeline.endTick).toBe(HOUR);
  });

  it("stays below 16 MB after 12 hours, and can still seek to its past", () => {
    const recording = new Recording(hall, driving[1]?.program ?? program([], "stop"));
    const sizes: number[] = [];
    for (let tick = 1; tick <= 12 * HOUR; tick++) {
      recording.step();
      if (tick % (4 * HOUR) === 0) sizes.push(recording.byteLength);
    }
    expect(Math.max(...sizes)).toBeLessThan(MAX_BYTES);
    const playback = recording.playback();
    playback.seek(5 * HOUR + 1234);
    expect(playback.run.tick).toBe(5 * HOUR + 1234);
  });
});

describe("edits", () => {
  const large = { ...hall, blocks: Array.from({ length: 101 }, () => ".".repeat(101)) };
  /** Memory use of a recording with 50 edits of the maze, in bytes. */
  function bytesOf(blocksAt: (edit: number) => string[]): number {
    const recording = new Recording(large, program([], "stop"));
    for (let edit = 1; edit <= 50; edit++) {
      recording.step();
      recording.addInput({ do: "maze", maze: { ...large, blocks: blocksAt(edit) } });
    }
    return recording.byteLength;
  }

  it("count only the parts that they do not share with the previous documents", () => {
    const row = (edit: number) => `${".".repeat(edit)}#`.padEnd(101, ".");
    const oneRow = bytesOf((edit) => large.blocks.with(100, row(edit)));
    const allRows = bytesOf((edit) => large.blocks.map((_, at) => (at > 50 ? row(edit) : row(1))));
    expect(allRows - oneRow).toBeGreaterThan(50 * 45 * 101);
  });
});
