import { describe, expect, it } from "vitest";
import { emptyFrame, messageIn, textFrame } from "./text-frame.ts";

const LETTERS = { "of one byte": "a", "of three bytes": "→", "of four bytes": "🤖" };

describe("a text frame", () => {
  it.each([
    { bytes: 0, header: [0x81, 0] },
    { bytes: 125, header: [0x81, 125] },
    { bytes: 126, header: [0x81, 126, 0, 126] },
    { bytes: 65_535, header: [0x81, 126, 0xff, 0xff] },
    { bytes: 65_536, header: [0x81, 127, 0, 0, 0, 0, 0, 1, 0, 0] },
  ])("has the header for $bytes bytes", ({ bytes, header }) => {
    const frame = textFrame("a".repeat(bytes));
    expect([...frame.subarray(0, header.length)]).toEqual(header);
    expect(frame.length).toBe(header.length + bytes);
  });

  it.each(Object.entries(LETTERS))("counts bytes, not characters: %s", (_name, letter) => {
    for (const letters of [1, 31, 32, 41, 42, 125, 126, 16_383, 16_384, 21_845, 21_846]) {
      const text = letter.repeat(letters);
      expect(messageIn(textFrame(text)).toString()).toBe(text);
    }
  });

  it("encodes a lone surrogate as Buffer does", () => {
    expect(messageIn(textFrame("half \ud83e"))).toEqual(Buffer.from("half \ud83e"));
  });

  it("can have a buffer of its own", () => {
    const frame = emptyFrame(200, { isRetained: true });
    expect(frame.buffer.byteLength).toBe(frame.length);
  });
});
