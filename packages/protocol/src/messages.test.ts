/** Golden messages in fixtures/, one file for each type and direction. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { z } from "zod";
import { decodeFrame, encodeFrame, MAX_FRAME_BYTES } from "./codec.ts";
import {
  driverToRelaySchema,
  helloSchema,
  MAX_RESUMED_ENDINGS,
  pageToRelaySchema,
  relayToDriverSchema,
  relayToPageSchema,
  resumeSchema,
  type Hello,
  type PageToRelay,
} from "./messages.ts";
import { snapshotOf } from "./testing/index.ts";

const FIXTURES = join(import.meta.dirname, "fixtures");

const schemas: [beginning: string, schema: z.ZodType][] = [
  ["hello", helloSchema],
  ["page-resume", resumeSchema],
  ["page-", pageToRelaySchema],
  ["driver-", driverToRelaySchema],
  ["relay-to-page-", relayToPageSchema],
  ["relay-to-driver-", relayToDriverSchema],
];

const golden = readdirSync(FIXTURES).map((file) => ({
  name: file.replace(".json", ""),
  text: readFileSync(join(FIXTURES, file), "utf8"),
  schema: schemas.find(([beginning]) => file.startsWith(beginning))?.[1] ?? helloSchema,
}));

const OPTIONAL: ReadonlySet<string> = new Set(["key", "sentAt"]);

describe("messages", () => {
  it.each(golden)("reads and rewrites the golden $name", ({ text, schema }) => {
    const read = decodeFrame(schema, text);
    expect(read).toEqual({ ok: true, value: JSON.parse(text) });
    const written = encodeFrame((read as { value: Hello }).value);
    expect(JSON.parse(written)).toEqual(JSON.parse(text));
  });

  it.each(golden)(
    "rejects $name with an unknown or missing field, and names the field",
    (message) => {
      const value = JSON.parse(message.text) as Record<string, unknown>;
      const more = decodeFrame(message.schema, JSON.stringify({ ...value, extra: 1 }));
      expect(more).toMatchObject({ ok: false, problems: [{ path: "extra" }] });
      const isNeeded = (field: string): boolean => !OPTIONAL.has(field) || value[field] === null;
      for (const field of Object.keys(value).filter(isNeeded)) {
        const { [field]: _left, ...less } = value;
        const read = decodeFrame(message.schema, JSON.stringify(less));
        expect(read).toMatchObject({ ok: false, problems: [{ path: field }] });
      }
    },
  );

  it("has a golden message for every type in every direction", () => {
    const typesOf = (schema: { options: readonly { shape: { type: { value: string } } }[] }) =>
      schema.options.map(({ shape }) => shape.type.value);
    const expected = [
      "hello",
      "page-resume",
      ...typesOf(pageToRelaySchema).map((type) => `page-${type}`),
      ...typesOf(driverToRelaySchema).map((type) => `driver-${type}`),
      ...typesOf(relayToPageSchema).map((type) => `relay-to-page-${type}`),
      ...typesOf(relayToDriverSchema).map((type) => `relay-to-driver-${type}`),
    ];
    expect(golden.map(({ name }) => name).toSorted()).toEqual(expected.toSorted());
  });

  it("never throws, for any text", () => {
    fc.assert(
      fc.property(fc.oneof(fc.string(), fc.json()), (text) => {
        for (const [, schema] of schemas) {
          const read = decodeFrame(schema, text);
          if (!read.ok && read.problems.length === 0) return false;
        }
        return true;
      }),
    );
  });

  it("rejects a message that is too long before parsing it", () => {
    const read = decodeFrame(pageToRelaySchema, "[".repeat(MAX_FRAME_BYTES + 1));
    expect(read).toMatchObject({ ok: false, problems: [{ expected: "at most 16384 characters" }] });
  });

  it("rejects a resume after which command numbers would exceed the safe integers", () => {
    const resume = { type: "resume", fresh: true, endings: [] };
    expect(resumeSchema.safeParse({ ...resume, lastApplied: 2 ** 48 }).success).toBe(true);
    for (const lastApplied of [2 ** 48 + 1, Number.MAX_SAFE_INTEGER]) {
      expect(resumeSchema.safeParse({ ...resume, lastApplied }).success).toBe(false);
    }
  });

  it("fits the longest resume into one message", () => {
    const ending: PageToRelay & { type: "ended" } = {
      type: "ended",
      epoch: 1,
      seq: Number.MAX_SAFE_INTEGER,
      state: "superseded",
      reason: "x".repeat(200),
      pose: { x: 12345.12345678901, y: 12345.12345678901, heading: 359.1234567890123 },
      distance: 12345.12345678901,
    };
    const { type: _type, epoch: _epoch, ...resumed } = ending;
    const endings = Array.from({ length: MAX_RESUMED_ENDINGS }, () => resumed);
    const far = 12345.12345678901;
    const snapshot = snapshotOf({ sensors: { front: far, right: far, back: far, left: far } });
    const text = encodeFrame({ type: "resume", lastApplied: 1, fresh: true, endings, snapshot });
    expect(text.length).toBeLessThanOrEqual(MAX_FRAME_BYTES);
    expect(decodeFrame(resumeSchema, text).ok).toBe(true);
  });
});
