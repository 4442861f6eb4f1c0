import {
  commandRecordSchema,
  decodeFrame,
  driverToRelaySchema,
  pageToRelaySchema,
} from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { answerText, commandText, parseSeq, snapshotText } from "./messages.ts";

describe("the messages of the load", () => {
  it("are valid for the relay", () => {
    expect(decodeFrame(pageToRelaySchema, snapshotText(7, 3)).ok).toBe(true);
    expect(decodeFrame(driverToRelaySchema, commandText(7)).ok).toBe(true);
    const { record } = JSON.parse(answerText(7)) as { record: unknown };
    expect(commandRecordSchema.safeParse(record).success).toBe(true);
  });

  it("have a number that is parsed in any field order", () => {
    expect(parseSeq(snapshotText(120, 3))).toBe(120);
    expect(parseSeq('{"tick":4,"seq":17}')).toBe(17);
    expect(parseSeq("{}")).toBeNaN();
  });
});
