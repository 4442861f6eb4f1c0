import type { Snapshot } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { CarriedSnapshot, readSnapshotMessage } from "./carried-snapshot.ts";

const plain = snapshotOf({ seq: 7, tick: 420, line: "default", command: 3 });
const bytesOf = (snapshot: unknown): Buffer =>
  Buffer.from(JSON.stringify({ type: "snapshot", epoch: 2, snapshot }));

function reordered({ seq, ...rest }: Snapshot): Snapshot {
  return { ...rest, seq };
}

describe("a carried snapshot", () => {
  it.each([
    { name: "made as an object", carried: CarriedSnapshot.of(plain) },
    { name: "found in a page's message", carried: readSnapshotMessage(bytesOf(plain))?.snapshot },
  ])("is the same to every reader: $name", ({ carried }) => {
    expect(carried).toMatchObject({ seq: 7, tick: 420, state: "running" });
    expect(carried?.value).toEqual(plain);
    expect(JSON.parse(String(carried?.json))).toEqual(plain);
    expect(JSON.parse(String(carried?.message))).toEqual({ type: "snapshot", snapshot: plain });
  });

  it.each([
    { name: "short", value: snapshotOf({ motion: "" }) },
    { name: "with letters of several bytes", value: snapshotOf({ motion: "→".repeat(40) }) },
  ])("is one complete WebSocket text frame: $name", ({ value }) => {
    const { frame, message } = CarriedSnapshot.of(value);
    expect([frame[0], frame[1]]).toEqual([0x81, 126]);
    expect(frame.readUInt16BE(2)).toBe(frame.length - 4);
    expect(message.length).toBeGreaterThan(125);
    expect(JSON.parse(frame.toString("utf8", 4))).toEqual({ type: "snapshot", snapshot: value });
  });

  it("does not change if its buffer is reused", () => {
    const bytes = bytesOf(plain);
    const found = readSnapshotMessage(bytes);
    bytes.fill(0);
    expect(found?.snapshot.value).toEqual(plain);
  });

  it.each([
    { name: "made as an object", carried: CarriedSnapshot.of(plain) },
    { name: "with its fields in another order", carried: CarriedSnapshot.of(reordered(plain)) },
    { name: "found in a page's message", carried: readSnapshotMessage(bytesOf(plain))?.snapshot },
  ])("can have another number: $name", ({ carried }) => {
    const numbered = carried?.numbered(123_456);
    expect(numbered).toMatchObject({ seq: 123_456, tick: 420, state: "running" });
    expect(numbered?.value).toEqual({ ...plain, seq: 123_456 });
    expect(JSON.parse(String(numbered?.message))).toMatchObject({ snapshot: numbered?.value });
  });

  it("can have another number and state", () => {
    const carried = readSnapshotMessage(bytesOf(plain))?.snapshot.with({ seq: 9, state: "gone" });
    expect(carried?.value).toEqual({ ...plain, seq: 9, state: "gone" });
    expect(JSON.parse(String(carried?.json))).toEqual(carried?.value);
  });

  it("is parsed by the schema if its text is unusual", () => {
    expect(readSnapshotMessage(bytesOf({ ...plain, motion: "höher" }))).toBeNull();
    expect(readSnapshotMessage(Buffer.from([0xff, 0xfe]))).toBeNull();
  });
});
