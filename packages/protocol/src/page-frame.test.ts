import { readFileSync } from "node:fs";
import { join } from "node:path";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { decodeFrame } from "./codec.ts";
import { pageToRelaySchema } from "./messages.ts";
import { decodePageFrame, isPlainSnapshot, readPlainSnapshot } from "./page-frame.ts";
import { snapshotSchema } from "./snapshot.ts";

type Tree = { [name: string]: unknown };

const FIXTURE = join(import.meta.dirname, "fixtures/page-snapshot.json");
const snapshotMessage = JSON.parse(readFileSync(FIXTURE, "utf8")) as Tree;
const plain = JSON.stringify(snapshotMessage);

// oxfmt-ignore
const strange: readonly unknown[] = [
  null, true, false, "", "default", "running", "gone", "me", "remote", "snapshot", {}, [],
  0, -0, 1, -1, 0.5, 359.999, 360, 361, -0.001, 25_600, 25_600.1, -25_600, -25_600.1,
  51_200, 51_200.1, 2 ** 53, 2 ** 53 - 1, -(2 ** 53), 1e308, "a".repeat(40), "a".repeat(41),
  "a:b", '"', "\\", "\u2028", "é".repeat(40), [[]], { x: 1 }, "1",
];

/** What may stand anywhere: around each bound, of each kind, and strange. */
const values = fc.oneof(fc.constantFrom<unknown>(...strange), fc.jsonValue());

/** Where a field stands: by the names that lead to it. */
const places = fc.constantFrom(...placesIn(snapshotMessage));

function placesIn(value: unknown, above: string[] = []): string[][] {
  if (typeof value !== "object" || value === null) return [];
  return Object.entries(value).flatMap(([name, inner]) => {
    const place = [...above, name];
    return [place, ...placesIn(inner, place)];
  });
}

/** The message with something else at that place; `undefined` takes the field away. */
function changed(message: Tree, [name = "", ...rest]: string[], value: unknown): Tree {
  if (rest.length === 0) return { ...message, [name]: value };
  const inner = message[name];
  if (typeof inner !== "object" || inner === null) return message;
  return { ...message, [name]: changed(inner as Tree, rest, value) };
}

const change = fc.tuple(places, fc.oneof(values, fc.constant(undefined)));
const messages = fc
  .array(change, { maxLength: 3 })
  .map((changes) =>
    changes.reduce<Tree>(
      (message, [place, value]) => changed(message, place, value),
      snapshotMessage,
    ),
  );

/** The same fields in an order of their own, some of them twice, or with another beside them. */
const texts = fc
  .tuple(
    messages,
    fc.constantFrom("", ',"seq":7', ',"extra":1', ',"__proto__":{}', ',"a:b":1', " "),
  )
  .map(([message, more]) => {
    const text = JSON.stringify(message);
    return text.endsWith("}}") ? `${text.slice(0, -2)}${more}}}` : text;
  });

/** The snapshot in a message, whatever it is; undefined in a text that is no message. */
function snapshotIn(text: string): unknown {
  try {
    return (JSON.parse(text) as Tree)["snapshot"];
  } catch {
    return undefined;
  }
}

describe("a snapshot that is checked by hand", () => {
  it("is what the schema makes of it, whatever is sent", () => {
    fc.assert(
      fc.property(texts, (text) => {
        const byHand = readPlainSnapshot(text);
        if (byHand === null) return;
        expect(decodeFrame(pageToRelaySchema, text)).toEqual({ ok: true, value: byHand });
      }),
      { numRuns: 5000 },
    );
  });

  it("is taken or refused as the schema does it, in the same words", () => {
    fc.assert(
      fc.property(fc.oneof(texts, fc.string()), (text) => {
        expect(decodePageFrame(text)).toEqual(decodeFrame(pageToRelaySchema, text));
      }),
      { numRuns: 2000 },
    );
  });

  it("is by itself what the schema makes of it, too", () => {
    fc.assert(
      fc.property(texts, (text) => {
        const snapshot = snapshotIn(text);
        if (!isPlainSnapshot(snapshot)) return;
        expect(snapshotSchema.parse(snapshot)).toEqual(snapshot);
      }),
      { numRuns: 5000 },
    );
    expect(isPlainSnapshot(snapshotMessage["snapshot"])).toBe(true);
  });

  it("is every ordinary one", () => {
    expect(readPlainSnapshot(plain)).toEqual(snapshotMessage);
  });

  it.each([
    { name: "a number that JSON can write and no robot has", from: "250.5", to: "1e999" },
    { name: "a field twice", from: '"tick":5678', to: '"tick":5678,"tick":5679' },
    { name: "a field twice, in place of another", from: '"bumps":0', to: '"tick":5679' },
    { name: "a field of another name", from: '"bumps":0', to: '"bump":0' },
    { name: "a field too many", from: '"bumps":0', to: '"bumps":0,"more":0' },
    { name: "a colon in a text", from: '"forward"', to: '"a:b"' },
    { name: "a pose as a list", from: '{"x":150,"y":150,"heading":90}', to: "[150,150,90]" },
  ])("leaves to the schema: $name", ({ from, to }) => {
    const text = plain.replace(from, to);
    expect(text).not.toBe(plain);
    expect(readPlainSnapshot(text)).toBeNull();
  });
});
