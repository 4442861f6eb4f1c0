import fc from "fast-check";
import { expect, it } from "vitest";
import { PackedTexts } from "./packed-texts.ts";

const step = fc.oneof(
  { weight: 3, arbitrary: fc.record({ push: fc.string({ unit: "grapheme", maxLength: 300 }) }) },
  fc.record({ shift: fc.nat({ max: 5 }) }),
  fc.record({ times: fc.nat({ max: 200 }), push: fc.constant("again and again") }),
);

it("returns each text unchanged and in order until it is released", () => {
  fc.assert(
    fc.property(fc.array(step, { maxLength: 60 }), (steps) => {
      const packed = new PackedTexts();
      const stored: string[] = [];
      for (const each of steps) {
        if ("shift" in each) {
          const count = Math.min(each.shift, stored.length);
          packed.shift(count);
          stored.splice(0, count);
        } else {
          const texts = Array<string>("times" in each ? each.times : 1).fill(each.push);
          for (const text of texts) packed.push(text);
          stored.push(...texts);
        }
        expect(packed.length).toBe(stored.length);
        expect(stored.map((_, at) => packed.at(at))).toEqual(stored);
      }
    }),
  );
});

it("needs little more memory than its texts, and frees memory after a peak", () => {
  const packed = new PackedTexts();
  const text = "x".repeat(132);
  for (let count = 0; count < 1_000; count++) packed.push(text);
  for (let count = 0; count < 3_000; count++) {
    packed.push(text);
    packed.shift(1);
  }
  expect(packed.bytes).toBeLessThanOrEqual(2 * 132 * 1_001);
  packed.shift(999);
  for (let count = 0; count < 3_000; count++) {
    packed.push(text);
    packed.shift(1);
  }
  expect(packed.bytes).toBeLessThanOrEqual(1_024);
  packed.shift(1);
  expect(packed.bytes).toBe(0);
});
