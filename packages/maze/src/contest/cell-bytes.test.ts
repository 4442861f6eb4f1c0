import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { parseMaze } from "../maze-document.ts";
import { isBinaryMaze } from "./cell-bytes.ts";
import { readBinaryMaze } from "./read-contest-maze.ts";
import { arbitraryContest } from "./testing/sample-contest.ts";
import { writeContestMaze } from "./write-contest-maze.ts";

const sides = fc.constant({ columns: 16, rows: 16 });

/** The bits of a wall after a turn to the right and, before it, a reflection that swaps east and west. */
function turnedBits(bits: number, turns: number, isMirrored: boolean): number {
  const [north, east, south, west] = [bits & 1, (bits >> 1) & 1, (bits >> 2) & 1, (bits >> 3) & 1];
  const around = isMirrored ? [north, west, south, east] : [north, east, south, west];
  const turned = around.map((_, at) => around[(at - turns + 4) % 4] ?? 0);
  return turned.reduce((sum, bit, at) => sum + (bit << at), 0);
}

describe("a binary file", () => {
  it("is read in all eight orientations, whatever the upper bits are", () => {
    const orientation = fc.record({
      turns: fc.integer({ min: 0, max: 3 }),
      isMirrored: fc.boolean(),
      upper: fc.constantFrom(0, 0xf0, 0x50),
    });
    fc.assert(
      fc.property(
        arbitraryContest({ sides, hasUsualStart: true }),
        orientation,
        (maze, { turns, isMirrored, upper }) => {
          const written = writeContestMaze(maze, "maz");
          if (!written.ok || typeof written.value === "string") throw new Error("expected bytes");
          const bytes = written.value.map(
            (bits, at) => turnedBits(bits, turns, isMirrored) | (at % 2 === 0 ? 0 : upper),
          );
          expect(bytes[0]).toBe([0x0e, 0x0d, 0x0b, 0x07][turns]);
          expect(isBinaryMaze(bytes)).toBe(true);
          expect(readBinaryMaze(bytes, maze.name)).toEqual({ ok: true, value: maze });
        },
      ),
    );
  });

  it("has byte 0 at the bottom left, byte 1 above it and byte 16 to its right", () => {
    const bytes = new Uint8Array(256).fill(15);
    bytes[0] = 0x0e;
    bytes[1] = 0x0b - 2;
    bytes[17] = 0x0f - 8;
    const read = readBinaryMaze(bytes, "");
    const blocks = read.ok ? read.value.blocks : [];
    expect(blocks.slice(-4)).toEqual([
      `#...${"#.".repeat(14)}#`,
      `#.${"#".repeat(31)}`,
      `#.${"#.".repeat(15)}#`,
      "#".repeat(33),
    ]);
  });

  it("is refused with the byte, if its walls do not agree", () => {
    const bytes = new Uint8Array(256).fill(15);
    bytes[0] = 0x0e;
    bytes[255] = 0x0d;
    expect(readBinaryMaze(bytes, "")).toEqual({
      ok: false,
      problems: [
        {
          path: "byte 0",
          found: "no wall in the north",
          expected: "a wall, as cell of byte 1 has on its side",
        },
        { path: "byte 255", found: "no wall in the east", expected: "the outer wall" },
      ],
    });
  });

  it("is no text, and has 256 bytes", () => {
    expect(isBinaryMaze(new Uint8Array(256))).toBe(true);
    expect(isBinaryMaze(new Uint8Array(255))).toBe(false);
    expect(isBinaryMaze(new Uint8Array(256).fill(32))).toBe(false);
    const dos = new Uint8Array(256).fill(0x2d).with(254, 10).with(255, 26);
    expect(isBinaryMaze(dos)).toBe(false);
  });

  it("is a valid maze or rejected with 1 to 20 problems, whatever it contains", () => {
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 300 }), (bytes) => {
        const read = readBinaryMaze(bytes, "");
        if (read.ok) return parseMaze(read.value).ok;
        return read.problems.length >= 1 && read.problems.length <= 20;
      }),
    );
  });
});
