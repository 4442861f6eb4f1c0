import { readFileSync } from "node:fs";
import { join } from "node:path";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { decodeFrame } from "./codec.ts";
import { pageToRelaySchema } from "./messages.ts";
import { MAX_LENGTH } from "./quantities.ts";
import { findSnapshot, findSnapshotMessage } from "./snapshot-text.ts";

type Tree = { [name: string]: unknown };

const FIXTURE = join(import.meta.dirname, "fixtures/page-snapshot.json");
const snapshotMessage = JSON.parse(readFileSync(FIXTURE, "utf8")) as Tree & { snapshot: Tree };
const plain = JSON.stringify(snapshotMessage);

// oxfmt-ignore
const unusual: readonly unknown[] = [
  null, true, false, "", "default", "running", "gone", "me", "remote", "snapshot", {}, [],
  0, -0, 1, -1, 0.5, 359.999, 360, 361, -0.001, 25_600, 25_600.1, -25_600, -25_600.1, 25_599.999,
  51_200, 51_200.1, 51_199.99, 2 ** 53, 2 ** 53 - 1, -(2 ** 53), 1e308, 1e-7, "a".repeat(40),
  "a".repeat(41), "a:b", '"', "\\", "\u2028", "é".repeat(40), "\u007f", "\u0000", [[]], { x: 1 }, "1",
];

/** Values at each bound, of each type, and unusual ones. */
const values = fc.oneof(fc.constantFrom<unknown>(...unusual), fc.double(), fc.jsonValue());

/** Paths of fields: the names from the root. */
const paths = fc.constantFrom(...pathsIn(snapshotMessage));

function pathsIn(value: unknown, parents: string[] = []): string[][] {
  if (typeof value !== "object" || value === null) return [];
  return Object.entries(value).flatMap(([name, inner]) => {
    const path = [...parents, name];
    return [path, ...pathsIn(inner, path)];
  });
}

/** The message with another value at that path; `undefined` removes the field. */
function changed(message: Tree, [name = "", ...rest]: string[], value: unknown): Tree {
  if (rest.length === 0) return { ...message, [name]: value };
  const inner = message[name];
  if (typeof inner !== "object" || inner === null) return message;
  return { ...message, [name]: changed(inner as Tree, rest, value) };
}

const change = fc.tuple(paths, fc.oneof(values, fc.constant(undefined)));
const messages = fc
  .array(change, { maxLength: 3 })
  .map((changes) =>
    changes.reduce<Tree>(
      (message, [path, value]) => changed(message, path, value),
      snapshotMessage,
    ),
  );

/** The same with an insertion that JSON.stringify does not write. */
const texts = fc
  .tuple(
    messages.map((message) => JSON.stringify(message)),
    fc.nat(),
    fc.constantFrom("", "", "0", "9", ".", "-", "e5", " ", ',"seq":7', ',"__proto__":{}', '"', "}"),
  )
  .map(([text, at, more]) => {
    const offset = at % (text.length + 1);
    return text.slice(0, offset) + more + text.slice(offset);
  });

function namesIn(text: string): string[] {
  return [...text.matchAll(/"(\w+)":/g)].map(([, name = ""]) => name);
}

describe("a snapshot in a text", () => {
  it("has the values that the schema parses, or does not match", () => {
    fc.assert(
      fc.property(texts, (text) => {
        const found = findSnapshotMessage(text);
        if (found === null) return;
        const read = decodeFrame(pageToRelaySchema, text);
        if (!read.ok || read.value.type !== "snapshot") throw new Error("the schema refuses it");
        const { epoch, snapshot } = read.value;
        const { seq, tick, state } = snapshot;
        expect(found).toMatchObject({ epoch, seq, tick, state });
        expect(JSON.parse(text.slice(found.start, found.end))).toEqual(snapshot);
        expect(findSnapshot(text, found.start)).toEqual({
          seq,
          tick,
          state,
          start: found.start,
          end: found.end,
        });
        // No duplicate fields, which JSON parsers treat differently.
        expect(namesIn(text)).toEqual(namesIn(plain));
      }),
      { numRuns: 20_000 },
    );
  });

  it("matches as JSON.stringify writes it", () => {
    const found = findSnapshotMessage(plain);
    expect(found).toMatchObject({ epoch: 3, seq: 1234, tick: 5678, state: "running" });
    expect(JSON.parse(plain.slice(found?.start, found?.end))).toEqual(snapshotMessage.snapshot);
  });

  const inPose = fc.double({ min: -MAX_LENGTH + 1, max: MAX_LENGTH - 1, noNaN: true });
  const inReading = fc.double({ min: 0.001, max: 2 * MAX_LENGTH - 1, noNaN: true });
  const inHeading = fc.double({ min: 0.001, max: 358.999, noNaN: true });
  it("matches for all values that a simulation reports", () => {
    fc.assert(
      fc.property(inPose, inPose, inReading, inHeading, (x, y, front, heading) => {
        const { sensors } = snapshotMessage.snapshot as { sensors: Tree };
        const snapshot = {
          ...snapshotMessage.snapshot,
          sensors: { ...sensors, front },
          pose: { x, y, heading },
        };
        const text = JSON.stringify({ ...snapshotMessage, snapshot });
        // The schema reads numbers with an exponent.
        if (text.includes("e-")) return;
        expect(findSnapshotMessage(text)).not.toBeNull();
      }),
    );
  });

  it("matches at the given offset only", () => {
    const one = JSON.stringify(snapshotMessage.snapshot);
    const text = `{"a":${one},"b":${one}}`;
    const first = findSnapshot(text, 5);
    expect(first?.end).toBe(5 + one.length);
    expect(findSnapshot(text, (first?.end ?? 0) + 5)?.end).toBe(text.length - 1);
    expect(findSnapshot(text, 6)).toBeNull();
    expect(findSnapshot(text, text.length + 9)).toBeNull();
  });

  it.each([
    { name: "a number that overflows", from: "250.5", to: "1e999" },
    { name: "a number with a leading zero", from: "250.5", to: "0250.5" },
    { name: "a number that ends with a point", from: "250.5", to: "250." },
    {
      name: "a heading that rounds up to a whole turn",
      from: '"heading":90',
      to: '"heading":359.99999999999999999',
    },
    { name: "a duplicate field", from: '"tick":5678', to: '"tick":5678,"tick":5679' },
    { name: "a duplicate field that replaces another", from: '"bumps":0', to: '"tick":5679' },
    { name: "a misspelled field", from: '"bumps":0', to: '"bump":0' },
    { name: "an unknown field", from: '"bumps":0', to: '"bumps":0,"more":0' },
    { name: "a space", from: '"bumps":0', to: '"bumps": 0' },
    { name: "an escape", from: '"forward"', to: String.raw`"f\u006frward"` },
    { name: "a pose as a list", from: '{"x":150,"y":150,"heading":90}', to: "[150,150,90]" },
    { name: "a line break after the message", from: /$/, to: "\n" },
    { name: "a second message after it", from: /$/, to: plain },
  ])("leaves to the schema: $name", ({ from, to }) => {
    const text = plain.replace(from, to);
    expect(text).not.toBe(plain);
    expect(findSnapshotMessage(text)).toBeNull();
  });
});
