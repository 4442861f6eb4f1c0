import { describe, expect, it } from "vitest";
import { readXml } from "./read-xml.ts";
import type { ObjectShape, SimpleShape } from "./shape.ts";
import { NAMESPACE, readFields } from "./values.ts";

/** The value of a field of this kind. */
function read(kind: SimpleShape["kind"], text: string): unknown {
  const value = { name: "value", isOptional: true, isList: false, description: "" };
  const simple = { kind, values: null, bounds: {} };
  const shape: ObjectShape = { kind: "object", name: null, fields: [{ ...value, shape: simple }] };
  const xml = `<Sense xmlns="${NAMESPACE}"><value>${text}</value></Sense>`;
  return readFields(readXml(xml), shape)["value"];
}

describe("a value in an element", () => {
  it.each([
    ["number", "40", 40],
    ["number", " -2.50\n", -2.5],
    ["number", "+.5", 0.5],
    ["number", "7.", 7],
    ["number", "1E-7", 1e-7],
    ["integer", "+12", 12],
    ["boolean", "1", true],
    ["boolean", "false", false],
    ["number or text", "60", 60],
    ["number or text", "right", "right"],
    ["text", " left 90 ", "left 90"],
    ["text", "12", "12"],
  ] as const)("of the kind %s is read from %j", (kind, text, value) => {
    expect(read(kind, text)).toBe(value);
  });

  it.each([
    ["number", "NaN"],
    ["number", "INF"],
    ["number", ""],
    ["number", "."],
    ["number", "0x10"],
    ["number", "1,5"],
    ["integer", "1.0"],
    ["boolean", "TRUE"],
  ] as const)("of the kind %s stays the text %j, which the schema refuses", (kind, text) => {
    expect(read(kind, text)).toBe(text);
  });

  it("is read in linear time, however long it is", () => {
    const text = `${"1".repeat(200_000)}x`;
    const startedAt = performance.now();
    expect(read("number", text)).toBe(text);
    expect(performance.now() - startedAt).toBeLessThan(5_000);
  });
});
