import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { z } from "zod";
import { describeProblem, readJson, readValue } from "./document-reader.ts";

const schema = z.strictObject(
  {
    name: z.string({ error: "a name" }),
    list: z.array(z.strictObject({ size: z.int({ error: "a whole number" }) })).max(3, {
      error: "at most 3",
    }),
  },
  { error: "an object" },
);

describe("a document that is wrong", () => {
  it.each([
    { text: '{"list":[]}', says: "name: found nothing, expected a name" },
    { text: '{"name":3,"list":[]}', says: "name: found 3, expected a name" },
    {
      text: '{"name":"a","list":[{"size":1},{"size":"2"}]}',
      says: 'list[1].size: found "2", expected a whole number',
    },
    { text: '{"name":"a","list":[],"x":[1]}', says: "x: found a list of 1, expected no field" },
    { text: '{"name":"a","list":[],"__proto__":{}}', says: "__proto__: found an object" },
    { text: '{"name":"a","list":[],"name":"b"}', says: "a field that stands twice in one object" },
    { text: '{"name":"a","list":[{"size":1,"size":1}]}', says: "a field that stands twice" },
    { text: "null", says: "document: found null, expected an object" },
    { text: "[]", says: "document: found a list of 0, expected an object" },
    { text: '{"name":', says: "expected a JSON document" },
    { text: "", says: "expected a JSON document" },
    { text: `"${"x".repeat(300)}"`, says: "found 302 characters, expected at most 200 characters" },
  ])("is refused: $says", ({ text, says }) => {
    const result = readJson(schema, text, 200);
    expect(result.ok).toBe(false);
    const lines = result.ok ? [] : result.problems.map(describeProblem);
    expect(lines.join("\n")).toContain(says);
  });

  it("lists at most 20 problems and never a long text", () => {
    const list = z.array(z.int({ error: "a whole number" }));
    const result = readValue(
      list,
      Array.from({ length: 500 }, () => "y".repeat(10_000)),
    );
    expect(result.ok).toBe(false);
    const problems = result.ok ? [] : result.problems;
    expect(problems).toHaveLength(20);
    for (const { found } of problems) expect(found.length).toBeLessThan(100);
  });
});

it("any JSON text gives a value or problems, and never an exception", () => {
  fc.assert(
    fc.property(fc.oneof(fc.json(), fc.string()), (text) => {
      const result = readJson(schema, text, 10_000);
      expect(result.ok || result.problems.length > 0).toBe(true);
    }),
  );
});

it("a JSON text that fits comes back as it is", () => {
  const value = { name: "a", list: [{ size: 1 }] };
  expect(readJson(schema, JSON.stringify(value), 200)).toEqual({ ok: true, value });
});
