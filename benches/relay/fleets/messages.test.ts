import {
  commandRecordSchema,
  decodeFrame,
  driverToRelaySchema,
  pageToRelaySchema,
} from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { answerText, commandText, numberIn, snapshotText } from "./messages.ts";

describe("what the load says", () => {
  it("is what the relay takes", () => {
    expect(decodeFrame(pageToRelaySchema, snapshotText(7, 3)).ok).toBe(true);
    expect(decodeFrame(driverToRelaySchema, commandText(7)).ok).toBe(true);
    const { record } = JSON.parse(answerText(7)) as { record: unknown };
    expect(commandRecordSchema.safeParse(record).success).toBe(true);
  });

  it("finds the number of a snapshot wherever it stands", () => {
    expect(numberIn(snapshotText(120, 3))).toBe(120);
    expect(numberIn('{"tick":4,"seq":17}')).toBe(17);
    expect(numberIn("{}")).toBeNaN();
  });
});
