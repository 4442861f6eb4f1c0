import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { decodeFrame } from "./codec.ts";
import { decodeDriverFrame, readPlainSeen } from "./driver-frame.ts";
import { driverToRelaySchema } from "./messages.ts";

const numbers = fc.oneof(
  fc.nat().map(String),
  fc.constantFrom("0", "-0", "00", "01", "1.0", "1e3", "-1", " 1", "1 ", "", "null", '"1"', "٣"),
  fc.constantFrom("999999999999999", "9007199254740991", "9007199254740992", "1,2"),
);
const ends = fc.constantFrom("}", " }", ',"seq":2}', ',"extra":1}', "", "}}");
const texts = fc.tuple(numbers, ends).map(([seq, end]) => `{"type":"seen","seq":${seq}${end}`);

describe("the hand-written parser of `seen`", () => {
  it("agrees with the schema for any text", () => {
    fc.assert(
      fc.property(texts, (text) => {
        expect(decodeDriverFrame(text)).toEqual(decodeFrame(driverToRelaySchema, text));
      }),
      { numRuns: 1000 },
    );
  });

  it("reads every `seen` that JSON.stringify writes", () => {
    fc.assert(
      fc.property(fc.nat(), (seq) => {
        expect(readPlainSeen(JSON.stringify({ type: "seen", seq }))).toBe(seq);
      }),
    );
  });
});
