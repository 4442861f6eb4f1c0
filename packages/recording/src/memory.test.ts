import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { Recording } from "./recording.ts";

const HOUR = 216_000;
const MOST_BYTES = 16 * 1024 * 1024;

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
  begin?: (recording: Recording) => void;
}[] = [
  {
    name: "a program that drives to and fro on every tick",
    program: program([{ when: { sensor: "front", is: "<", than: 400 }, do: "reverse" }], "forward"),
  },
  {
    name: "a program that bumps and turns",
    program: program([{ when: { sensor: "front", is: "<", than: 30 }, do: "right 90" }], "forward"),
  },
  {
    name: "a script that drives in arcs",
    program: program([], "stop"),
    begin: (recording) => {
      recording.addInput({ do: "driver", driver: "remote" });
      const command = { action: "drive" as const, left: 0.5, right: 0.3 };
      recording.addInput({ do: "command", command, seq: 1 });
    },
  },
  {
    name: "a hand that presses a key every tenth of a second",
    program: program([], "stop"),
    begin: (recording) => void recording.addInput({ do: "driver", driver: "me" }),
  },
];

describe("an hour of running", () => {
  it.each(driving)("stays far below 16 MB: $name", ({ name, program: driver, begin }) => {
    const recording = new Recording(hall, driver);
    begin?.(recording);
    for (let tick = 0; tick < HOUR; tick++) {
      if (name.startsWith("a hand") && tick % 6 === 0) {
        const action = tick % 12 === 0 ? ("forward" as const) : ("reverse" as const);
        recording.addInput({ do: "command", command: { action } });
      }
      recording.step();
    }
    expect(recording.run.tick).toBe(HOUR);
    expect(recording.byteLength).toBeLessThan(MOST_BYTES);
    // What the timeline tells is still the whole hour.
    const { timeline } = recording;
    expect(timeline.tickOf(0)).toBe(0);
    expect(timeline.endTick).toBe(HOUR);
  });

  it("is not the most: a day at the highest speed stays bounded, and its past can be shown", () => {
    const recording = new Recording(hall, driving[1]?.program ?? program([], "stop"));
    const sizes: number[] = [];
    for (let tick = 1; tick <= 12 * HOUR; tick++) {
      recording.step();
      if (tick % (4 * HOUR) === 0) sizes.push(recording.byteLength);
    }
    expect(Math.max(...sizes)).toBeLessThan(MOST_BYTES);
    const playback = recording.playback();
    playback.seek(5 * HOUR + 1234);
    expect(playback.run.tick).toBe(5 * HOUR + 1234);
  });
});

describe("edits", () => {
  const large = { ...hall, blocks: Array.from({ length: 101 }, () => ".".repeat(101)) };
  /** Bytes of a recording whose maze is edited so often. */
  function bytesOf(blocksAt: (edit: number) => string[]): number {
    const recording = new Recording(large, program([], "stop"));
    for (let edit = 1; edit <= 50; edit++) {
      recording.step();
      recording.addInput({ do: "maze", maze: { ...large, blocks: blocksAt(edit) } });
    }
    return recording.byteLength;
  }

  it("count with what they do not share with the documents before them", () => {
    const row = (edit: number) => `${".".repeat(edit)}#`.padEnd(101, ".");
    const oneRow = bytesOf((edit) => large.blocks.with(100, row(edit)));
    const allRows = bytesOf((edit) => large.blocks.map((_, at) => (at > 50 ? row(edit) : row(1))));
    expect(allRows - oneRow).toBeGreaterThan(50 * 45 * 101);
  });
});
