import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { z } from "zod";
import { describeProblem, parseJson, readJson, readValue } from "./document-reader.ts";

const schema = z.strictObject(
  {
    name: z.string({ error: "a name" }),
    list: z.array(z.strictObject({ size: z.int({ error: "a whole number" }) })).max(3, {
      error: "at most 3",
    }),
  },
  { error: "an object" },
);

describe("an invalid document", () => {
  it.each([
    { text: '{"list":[]}', message: "name: found nothing, expected a name" },
    { text: '{"name":3,"list":[]}', message: "name: found 3, expected a name" },
    {
      text: '{"name":"a","list":[{"size":1},{"size":"2"}]}',
      message: 'list[1].size: found "2", expected a whole number',
    },
    { text: '{"name":"a","list":[],"x":[1]}', message: "x: found a list of 1, expected no field" },
    { text: '{"name":"a","list":[],"__proto__":{}}', message: "__proto__: found an object" },
    { text: '{"name":"a","list":[],"name":"b"}', message: "a duplicate field in an object" },
    { text: '{"name":"a","list":[{"size":1,"size":1}]}', message: "a duplicate field" },
    { text: "null", message: "document: found null, expected an object" },
    { text: "[]", message: "document: found a list of 0, expected an object" },
    { text: '{"name":', message: "expected a JSON document" },
    { text: "", message: "expected a JSON document" },
    {
      text: `"${"x".repeat(300)}"`,
      message: "found 302 characters, expected at most 200 characters",
    },
  ])("is rejected: $message", ({ text, message }) => {
    const result = readJson(schema, text, 200);
    expect(result.ok).toBe(false);
    const lines = result.ok ? [] : result.problems.map(describeProblem);
    expect(lines.join("\n")).toContain(message);
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

it("any text results in a value or problems, and never in an exception", () => {
  fc.assert(
    fc.property(fc.oneof(fc.json(), fc.string()), (text) => {
      const result = readJson(schema, text, 10_000);
      expect(result.ok || result.problems.length > 0).toBe(true);
    }),
  );
});

it("a valid JSON text is returned unchanged", () => {
  const value = { name: "a", list: [{ size: 1 }] };
  expect(readJson(schema, JSON.stringify(value), 200)).toEqual({ ok: true, value });
});

it("reports whether a text is JSON apart from whether it may be read", () => {
  expect(parseJson('{"a":[1]}', 20)).toEqual({ ok: true, value: { a: [1] } });
  const found = expect.stringMatching(/^text that is not JSON: ./);
  expect(parseJson("left 90", 20)).toMatchObject({ problems: [{ found }] });
  expect(parseJson("left 90", 20)).toMatchObject({ ok: false, isJson: false });
  expect(parseJson('{"a":1,"a":2}', 20)).toMatchObject({ ok: false, isJson: true });
  expect(parseJson("[1, 2, 3]", 5)).toMatchObject({ ok: false, isJson: true });
});
