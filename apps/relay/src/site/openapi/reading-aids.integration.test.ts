import { commandRecordSchema, orderSchema, snapshotSchema } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { describedCalls } from "../../testing/described-relay.ts";
import { describeApi } from "./document.ts";
import { groups, orderExample, recordExample, snapshotExample } from "./reading-aids.ts";

const calls = describedCalls(describeApi());

describe("groups and examples of the description", () => {
  it("assigns every operation to one group, and leaves no group empty", () => {
    const used = calls.map(({ operation }) => operation.tags?.join() ?? "none");
    expect(new Set(used)).toEqual(new Set(groups.map(({ name }) => name)));
  });

  it("offers a valid example command", () => {
    const send = calls.find(({ operation }) => operation.operationId === "sendCommand");
    expect(send?.operation.requestBody).toHaveProperty(
      ["content", "application/json", "example"],
      orderExample,
    );
    expect(orderSchema.parse(orderExample)).toEqual(orderExample);
  });

  it("contains valid example responses", () => {
    expect(snapshotSchema.parse(snapshotExample)).toEqual(snapshotExample);
    expect(commandRecordSchema.parse(recordExample)).toEqual(recordExample);
    expect(JSON.stringify(calls)).toContain(JSON.stringify(snapshotExample));
  });
});
