/** Golden messages in class-fixtures/, one file for each type and direction. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { z } from "zod";
import {
  classHelloSchema,
  relayToScreenSchema,
  relayToStudentSchema,
  relayToTeacherSchema,
  screenToRelaySchema,
  studentToRelaySchema,
  teacherToRelaySchema,
  type ClassHello,
} from "./class-messages.ts";
import { decodeFrame, encodeFrame, MAX_FRAME_BYTES, MAX_HELLO_BYTES } from "./codec.ts";
import { decodeTeacherFrame, MAX_DISPLAY_LENGTH } from "./teacher-frame.ts";

const FIXTURES = join(import.meta.dirname, "class-fixtures");

const directions = {
  student: studentToRelaySchema,
  teacher: teacherToRelaySchema,
  screen: screenToRelaySchema,
  "relay-to-student": relayToStudentSchema,
  "relay-to-teacher": relayToTeacherSchema,
  "relay-to-screen": relayToScreenSchema,
};

const golden = readdirSync(FIXTURES).map((file) => {
  const name = file.replace(".json", "");
  const text = readFileSync(join(FIXTURES, file), "utf8");
  const direction = name.slice(0, name.lastIndexOf("-"));
  const found = Object.entries(directions).find(([known]) => known === direction);
  const schema: z.ZodType = found?.[1] ?? classHelloSchema;
  return { name, text, schema };
});

describe("messages of a class", () => {
  it.each(golden)("reads and rewrites the golden $name", ({ text, schema }) => {
    const read = decodeFrame(schema, text);
    expect(read).toEqual({ ok: true, value: JSON.parse(text) });
    const written = encodeFrame((read as { value: ClassHello }).value);
    expect(JSON.parse(written)).toEqual(JSON.parse(text));
  });

  it.each(golden)("rejects $name with an unknown or missing field", ({ text, schema }) => {
    const value = JSON.parse(text) as Record<string, unknown>;
    const more = decodeFrame(schema, JSON.stringify({ ...value, extra: 1 }));
    expect(more).toMatchObject({ ok: false, problems: [{ path: "extra" }] });
    for (const field of Object.keys(value)) {
      const { [field]: _left, ...less } = value;
      const read = decodeFrame(schema, JSON.stringify(less));
      expect(read).toMatchObject({ ok: false, problems: [{ path: field }] });
    }
  });

  it("has a golden message for every type in every direction", () => {
    const expected = Object.entries(directions).flatMap(([direction, { options }]) =>
      options.map(({ shape }) => `${direction}-${shape.type.value}`),
    );
    expect(golden.map(({ name }) => name).toSorted()).toEqual(["hello", ...expected].toSorted());
  });

  it("never throws, for any text", () => {
    fc.assert(
      fc.property(fc.oneof(fc.string(), fc.json()), (text) => {
        const schemas: z.ZodType[] = [classHelloSchema, ...Object.values(directions)];
        return schemas.every((schema) => {
          const read = decodeFrame(schema, text);
          return read.ok || read.problems.length > 0;
        });
      }),
    );
  });

  it("fits a hello into its limit", () => {
    const key = `tea_${"A".repeat(22)}`;
    const since = `abcdefgh-${"9".repeat(15)}`;
    const hello = encodeFrame({ type: "hello", version: 1, role: "teach", key, since });
    expect(hello.length).toBeLessThanOrEqual(MAX_HELLO_BYTES);
  });

  it("permits only the display of a dashboard to exceed 16 KiB", () => {
    const display = (length: number) =>
      JSON.stringify({ type: "display", content: { runs: "x".repeat(length) } });
    expect(decodeTeacherFrame(display(MAX_FRAME_BYTES)).ok).toBe(true);
    expect(decodeTeacherFrame(display(MAX_DISPLAY_LENGTH)).ok).toBe(false);
    const padded = `{"type":"seen","seq":1${" ".repeat(MAX_FRAME_BYTES)}}`;
    expect(decodeTeacherFrame(padded)).toMatchObject({
      problems: [{ expected: "at most 16384 characters" }],
    });
  });
});
