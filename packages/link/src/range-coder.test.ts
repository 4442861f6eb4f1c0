import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { codeFloat, codeUniform, NumberModel, SymbolModel } from "./numbers.ts";
import { BitModel, Decoder, Encoder, type BitCoder } from "./range-coder.ts";

/** Encodes values, then decodes them. The decoder receives `other`, which it must ignore. */
function roundTrip<T>(values: readonly T[], other: T, code: (coder: BitCoder, value: T) => T) {
  const encoder = new Encoder();
  for (const value of values) code(encoder, value);
  return (read: (coder: BitCoder, value: T) => T) => {
    const digits = encoder.finish();
    const decoder = new Decoder(digits);
    const decoded = values.map(() => read(decoder, other));
    return { digits, decoded, missing: decoder.missing() };
  };
}

describe("the range coder", () => {
  it("decodes every bit for any expected frequencies, and ends at the last digit", () => {
    const count = fc.oneof(
      fc.integer({ min: 1, max: 65_535 }),
      fc.constantFrom(1, 2, 65_534, 65_535),
    );
    const step = fc.record({ zeros: count, ones: count, bit: fc.integer({ min: 0, max: 1 }) });
    fc.assert(
      fc.property(fc.array(step, { maxLength: 2_000, size: "max" }), (steps) => {
        const encoder = new Encoder();
        for (const { zeros, ones, bit } of steps) encoder.bit(zeros, ones, bit);
        const digits = encoder.finish();
        expect(digits.every((digit) => Number.isInteger(digit) && digit >= 0 && digit < 64)).toBe(
          true,
        );
        const decoder = new Decoder(digits);
        expect(steps.map(({ zeros, ones }) => decoder.bit(zeros, ones))).toEqual(
          steps.map(({ bit }) => bit),
        );
        expect(decoder.missing()).toBe(0);
      }),
    );
  });

  it("encodes 10,000 predictable bits in fewer than 8 digits", () => {
    const model = new BitModel(1, 4);
    const encoder = new Encoder();
    for (let count = 0; count < 10_000; count += 1) model.code(encoder, 0, 0);
    expect(encoder.finish().length).toBeLessThan(8);
  });

  it("codes uniform numbers, symbols, whole numbers and doubles exactly", () => {
    fc.assert(
      fc.property(fc.integer({ min: 1, max: 65_536 }), fc.array(fc.nat()), (limit, raw) => {
        const values = raw.map((value) => value % limit);
        const code = (coder: BitCoder, value: number) => codeUniform(coder, limit, value);
        expect(roundTrip(values, 0, code)(code)).toMatchObject({ decoded: values, missing: 0 });
      }),
    );
    fc.assert(
      fc.property(fc.array(fc.integer({ min: 0, max: 15 })), (values) => {
        const [writing, reading] = [new SymbolModel(4), new SymbolModel(4)];
        const write = roundTrip(values, 0, (coder, value) => writing.code(coder, value));
        expect(write((coder, value) => reading.code(coder, value)).decoded).toEqual(values);
      }),
    );
    fc.assert(
      fc.property(fc.array(fc.integer({ min: 0, max: 2 ** 20 - 2 })), (values) => {
        const [writing, reading] = [new NumberModel(), new NumberModel()];
        const write = roundTrip(values, 0, (coder, value) => writing.code(coder, value));
        expect(write((coder, value) => reading.code(coder, value)).decoded).toEqual(values);
      }),
    );
    fc.assert(
      fc.property(fc.array(fc.double()), (values) => {
        expect(roundTrip(values, 0, codeFloat)(codeFloat).decoded).toEqual(values);
      }),
    );
  });

  it("decodes any digits without an exception, followed by zeros", () => {
    const decoder = new Decoder([63, 63, 63]);
    const bits = Array.from({ length: 500 }, () => decoder.bit(3, 5));
    expect(bits.every((bit) => bit === 0 || bit === 1)).toBe(true);
    expect(decoder.missing()).toBeGreaterThan(0);
  });
});
