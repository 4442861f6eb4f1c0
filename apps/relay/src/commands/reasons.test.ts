import { commandRecordSchema, expiredReason } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { recordOfRow } from "./robot-commands.ts";
import { causes, reasonText, recallCauseIn } from "./reasons.ts";
import { rowOf } from "./testing/robot-with.ts";

describe("the reason in a command's record", () => {
  it.each(causes)("is a sentence of its own that fits into a record: %s", (cause) => {
    const row = rowOf({ state: "cancelled", reason: { cause, by: 4 }, distance: 0 });
    const { reason } = commandRecordSchema.parse(recordOfRow(row));
    expect(reason).toMatch(/^[A-Z].*\.$/);
    const all = causes.map((each) => reasonText({ cause: each, by: 4 }, row.ttl));
    expect(all.filter((text) => text === reason)).toHaveLength(1);
  });

  it("names the command that overtook it, or the time in which it did not start", () => {
    expect(reasonText({ cause: "stopped", by: 4 }, 400)).toBe("Command 4 stopped this command.");
    expect(reasonText({ cause: "replaced", by: 5 }, 400)).toBe("Command 5 replaced this command.");
    expect(reasonText({ cause: "expired", by: null }, 400)).toBe(expiredReason(400));
    expect(reasonText({ cause: "expired-absent", by: null }, 400)).toBe(
      expiredReason(400, "absent"),
    );
  });

  it("is the robot's own sentence if the robot ended the command", () => {
    const row = rowOf({ state: "collided", reason: "It met a wall." });
    expect(recordOfRow(row).reason).toBe("It met a wall.");
    expect(recordOfRow(rowOf()).reason).toBeNull();
  });
});

it("reads the cause of a recall, also from rows that held a sentence", () => {
  expect(recallCauseIn(null)).toBeNull();
  expect(recallCauseIn("paused")).toBe("paused");
  expect(recallCauseIn("The owner revoked the key that sent this command.")).toBe("sender");
});
