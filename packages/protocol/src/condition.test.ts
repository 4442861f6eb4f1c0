import { describe, expect, it } from "vitest";
import { readValue } from "./document-reader.ts";
import { MAX_CONDITIONS } from "./condition-bounds.ts";
import { commandRecordSchema } from "./command-record.ts";
import { commandSchema, remoteCommandSchema } from "./command.ts";
import { orderSchema } from "./order.ts";
import { timedCommandsSchema } from "./timed-command.ts";

const NEAR = { sensor: "front", is: "<=", than: 60 };
const OPEN = { sensor: "left", is: ">", than: "right", plus: 1 };

function problemsOf(order: unknown) {
  const result = readValue(orderSchema, order);
  return result.ok ? [] : result.problems;
}

describe("an order with until", () => {
  it.each([
    { action: "forward", until: [NEAR, OPEN, { goal: true }], ttl: 1_000, replace: true },
    { action: "reverse", until: [{ goal: true }] },
    { action: "drive", left: 0.2, right: 0.2, until: Array(MAX_CONDITIONS).fill(NEAR) },
  ])("is read: %j", (order) => {
    expect(readValue(orderSchema, order)).toEqual({ ok: true, value: order });
  });

  it.each([
    { name: "another action", order: { action: "left 90", until: [NEAR] }, path: "until" },
    { name: "a stop", order: { action: "stop", until: [NEAR] }, path: "until" },
    { name: "a move", order: { action: "move", distance: 1, until: [NEAR] }, path: "until" },
    {
      name: "a drive with milliseconds",
      order: { action: "drive", left: 0, right: 0, milliseconds: 9, until: [NEAR] },
      path: "until",
    },
    {
      name: "a drive with a lease",
      order: { action: "drive", left: 0, right: 0, lease: 500, until: [NEAR] },
      path: "until",
    },
    { name: "no conditions", order: { action: "forward", until: [] }, path: "until" },
    {
      name: "too many conditions",
      order: { action: "forward", until: Array(MAX_CONDITIONS + 1).fill(NEAR) },
      path: "until",
    },
    {
      name: "an unknown comparator",
      order: { action: "forward", until: [NEAR, { ...NEAR, is: "=" }] },
      path: "until[1].is",
    },
    {
      name: "a number out of range",
      order: { action: "forward", until: [{ ...NEAR, than: -1 }] },
      path: "until[0].than",
    },
    {
      name: "a goal that is false",
      order: { action: "forward", until: [{ goal: false }] },
      path: "until[0].goal",
    },
    {
      name: "a goal with more fields",
      order: { action: "forward", until: [{ goal: true, sensor: "front" }] },
      path: "until[0].sensor",
    },
    {
      name: "another sensor against right",
      order: { action: "forward", until: [{ ...OPEN, sensor: "front" }] },
      path: "until[0].sensor",
    },
  ])("is refused with $name, and the problem names the field", ({ order, path }) => {
    expect(problemsOf(order)).toMatchObject([{ path }]);
  });
});

describe("until", () => {
  const command = { action: "forward", until: [NEAR] };

  it("is part of the command of a script", () => {
    expect(readValue(remoteCommandSchema, command)).toEqual({ ok: true, value: command });
    expect(commandRecordSchema.shape.command.safeParse(command).success).toBe(true);
  });

  it("is no part of the commands in documents", () => {
    expect(readValue(commandSchema, command)).toMatchObject({ ok: false });
    expect(readValue(timedCommandsSchema, [{ tick: 0, command }])).toMatchObject({ ok: false });
  });
});
