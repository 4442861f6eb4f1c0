import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { LineReader } from "./line-reader.ts";

const MAX = 16 * 1024;

function linesOf(...chunks: (string | Buffer)[]): (string | null)[] {
  const reader = new LineReader();
  return chunks.flatMap((chunk) => [...reader.add(Buffer.from(chunk))]);
}

describe("lines of a connection", () => {
  it("end with \\n or \\r\\n, wherever the bytes are split", () => {
    const line = fc.string({ unit: "grapheme" }).map((text) => text.replaceAll(/\s/g, "x"));
    const end = fc.constantFrom("\n", "\r\n");
    const cuts = fc.array(fc.nat({ max: 200 }));
    fc.assert(
      fc.property(fc.array(fc.tuple(line, end)), cuts, (lines, places) => {
        const bytes = Buffer.from(lines.flat().join(""));
        const sorted = [0, ...places.toSorted((a, b) => a - b), bytes.length];
        const chunks = sorted.map((from, at) => bytes.subarray(from, sorted[at + 1] ?? from));
        expect(linesOf(...chunks)).toEqual(lines.map(([text]) => text));
      }),
    );
  });

  it("have at most 16 KiB, and a longer one does not harm the next", () => {
    const longest = "x".repeat(MAX);
    expect(linesOf(`${longest}\n${longest}x\nnext\n`)).toEqual([longest, null, "next"]);
  });

  it("are refused once, as soon as they are too long", () => {
    const flood = Array.from({ length: 1_000 }, () => "x".repeat(MAX));
    expect(linesOf(...flood)).toEqual([null]);
    expect(linesOf(...flood, "\nnext\n")).toEqual([null, "next"]);
  });

  it("may begin with a byte order mark", () => {
    expect(linesOf("\uFEFF{}\n")).toEqual(["{}"]);
  });

  it("may contain bytes that are no UTF-8", () => {
    expect(linesOf(Buffer.from([0xff, 0xfe, 0x0a]))).toEqual(["\uFFFD\uFFFD"]);
  });

  it("wait for their end", () => {
    expect(linesOf('{"servos":', "[]}")).toEqual([]);
    expect(linesOf('{"servos":', "[]}", "\r", "\n\n")).toEqual(['{"servos":[]}', ""]);
  });
});
