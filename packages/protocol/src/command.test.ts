import { describe, expect, it } from "vitest";
import { commandRecordSchema } from "./command-record.ts";
import { commandSchema } from "./command.ts";
import { readValue } from "./document-reader.ts";
import { orderSchema } from "./order.ts";

const RESET = { action: "reset" };

describe("a reset", () => {
  it("is sent by scripts, with the terms of every command", () => {
    const order = { ...RESET, ttl: 2_000, replace: true };
    expect(readValue(orderSchema, order)).toEqual({ ok: true, value: order });
  });

  it("takes neither conditions nor other fields", () => {
    const near = { sensor: "front", is: "<=", than: 60 };
    for (const fields of [{ until: [near] }, { lease: 500 }, { distance: 1 }])
      expect(readValue(orderSchema, { ...RESET, ...fields }).ok).toBe(false);
  });

  it("is no command of programs, runs and links", () => {
    expect(readValue(commandSchema, RESET).ok).toBe(false);
  });
});

describe("an action that this version does not know", () => {
  const command = { action: "fly", height: 3 };

  it("is read in records, with the fields of its command", () => {
    const record = {
      seq: 1,
      key: null,
      action: "fly",
      command,
      state: "completed",
      reason: null,
      acceptedAt: "2026-01-01T00:00:00.000Z",
      pose: null,
      distance: 0,
      duplicate: false,
    };
    expect(readValue(commandRecordSchema, record)).toEqual({ ok: true, value: record });
  });

  it("cannot be sent, and the error lists the actions that can", () => {
    const result = readValue(orderSchema, { action: "rest" });
    expect(result).toMatchObject({
      ok: false,
      problems: [{ path: "action", expected: expect.stringContaining("reset") }],
    });
  });
});
