import { describe, expect, it } from "vitest";
import type { oas31 } from "zod-openapi";
import { describedCalls } from "../../testing/described-relay.ts";
import { describeApi } from "./document.ts";

const document = describeApi();

/** All objects in the document, recursively. */
function* nodes(value: unknown): Generator<Record<string, unknown>> {
  if (typeof value !== "object" || value === null) return;
  yield value as Record<string, unknown>;
  for (const child of Object.values(value)) yield* nodes(child);
}

function at(reference: string): unknown {
  const parts = reference.slice(2).split("/");
  return parts.reduce<unknown>(
    (node, part) => (node as Record<string, unknown> | undefined)?.[part],
    document,
  );
}

const calls = describedCalls(document);

describe("the description of the API", () => {
  it("is OpenAPI 3.1 with a title and a version", () => {
    expect(document.openapi).toMatch(/^3\.1\.\d$/);
    expect(document.info).toMatchObject({ title: "Corridor", version: "1.0.0" });
    expect(document.info.description).toContain("/docs");
    // Plain JSON: serialisation is lossless.
    expect(JSON.parse(JSON.stringify(document))).toEqual(document);
  });

  it("resolves every reference", () => {
    const references = [...nodes(document)].flatMap(({ $ref }) =>
      typeof $ref === "string" ? [$ref] : [],
    );
    expect(references.length).toBeGreaterThan(20);
    expect(references.filter((reference) => !reference.startsWith("#/"))).toEqual([]);
    expect(references.filter((reference) => typeof at(reference) !== "object")).toEqual([]);
  });

  it.each([
    "Command",
    "CommandRecord",
    "Snapshot",
    "Registration",
    "ShortLink",
    "SharedDocument",
    "Problem",
  ])("defines %s in one place and references it elsewhere", (name) => {
    const reference = `#/components/schemas/${name}`;
    const uses = [...nodes(document)].filter(({ $ref }) => $ref === reference);
    expect(uses.length).toBeGreaterThan(0);
    const text = JSON.stringify(at(reference));
    expect(JSON.stringify(document).split(text)).toHaveLength(2);
  });

  it("names every object of a body and every alternative", () => {
    const bodies = calls.flatMap(({ operation: { requestBody, responses } }) =>
      [requestBody, ...Object.values(responses ?? {})].flatMap((holder) =>
        Object.values((holder as oas31.ResponseObject | undefined)?.content ?? {}),
      ),
    );
    for (const { schema } of bodies) expect(schema).toHaveProperty("$ref");
    const alternatives = [...nodes(document)].flatMap(({ oneOf }) => (oneOf ?? []) as object[]);
    expect(alternatives.length).toBeGreaterThan(30);
    for (const alternative of alternatives) expect(alternative).toHaveProperty("$ref");
    const choices = [...nodes(document)].flatMap(({ anyOf }) => (anyOf ?? []) as object[]);
    expect(choices.filter((choice) => "properties" in choice)).toEqual([]);
  });

  it("names the kinds of a condition, as generated clients show them", () => {
    const kindsOf = (name: string) =>
      (at(`#/components/schemas/${name}`) as { anyOf: { $ref: string }[] }).anyOf.map(({ $ref }) =>
        $ref.replace("#/components/schemas/", ""),
      );
    expect(kindsOf("UntilCondition")).toEqual([
      "SensorUntilCondition",
      "LeftRightUntilCondition",
      "GoalUntilCondition",
    ]);
    expect(kindsOf("RuleCondition")).toEqual(["SensorRuleCondition", "LeftRightRuleCondition"]);
  });

  it("gives every constant the type of its value, a version a whole number", () => {
    const constants = [...nodes(document)].filter((node) => "const" in node);
    expect(constants.length).toBeGreaterThan(30);
    for (const { const: value, type } of constants) {
      expect({ value, type }).toEqual({
        value,
        type: Number.isInteger(value) ? "integer" : typeof value,
      });
    }
  });

  it("names the items of every set, which generators of Java need", () => {
    const sets = [...nodes(document)].filter(({ uniqueItems }) => uniqueItems === true);
    expect(sets.length).toBeGreaterThan(5);
    for (const { items } of sets) expect(items).toHaveProperty("$ref");
  });

  it("discriminates alternatives only by strings, as OpenAPI requires", () => {
    expect(at("#/components/schemas/SharedDocument")).toHaveProperty("discriminator");
    expect(at("#/components/schemas/ChallengeOrLesson")).not.toHaveProperty("discriminator");
  });

  it("allows further fields in responses, and none in commands", () => {
    for (const name of ["Snapshot", "Pose", "CommandRecord", "EventPage", "Problem"]) {
      expect(at(`#/components/schemas/${name}`)).not.toHaveProperty("additionalProperties");
    }
    for (const name of ["MoveOrder", "KeyRequest"]) {
      expect(at(`#/components/schemas/${name}`)).toHaveProperty("additionalProperties", false);
    }
  });

  it("lists the motions of a robot", () => {
    expect(at("#/components/schemas/Snapshot")).toHaveProperty(
      "properties.motion.enum",
      expect.arrayContaining(["stop", "move", "left 90"]),
    );
  });

  it("gives every operation a unique id", () => {
    const names = calls.map(({ operation }) => operation.operationId);
    expect(names).not.toContain(undefined);
    expect(new Set(names).size).toBe(calls.length);
  });

  it.each(calls)("declares every parameter once: $name", ({ path, parameters }) => {
    const inPath = parameters.filter((parameter) => parameter.in === "path");
    expect(inPath.map(({ name }) => `{${name}}`)).toEqual(path.match(/\{\w+\}/g) ?? []);
    for (const parameter of inPath) expect(parameter.required).toBe(true);
    const places = parameters.map((parameter) => `${parameter.in} ${parameter.name}`);
    expect(new Set(places).size).toBe(places.length);
    for (const { schema } of parameters) expect(schema).toHaveProperty("type");
  });

  it.each(calls)("documents security and responses: $name", ({ operation }) => {
    expect(operation.summary).toMatch(/\w+ \w+/);
    for (const requirement of operation.security ?? [{ missing: [] }]) {
      for (const scheme of Object.keys(requirement)) {
        expect(document.components?.securitySchemes).toHaveProperty(scheme, {
          type: "http",
          scheme: "bearer",
          description: expect.any(String),
        });
      }
    }
    const answers = Object.entries(operation.responses ?? {}) as [string, oas31.ResponseObject][];
    // 304 has no body, only the ETag.
    const refusals = answers.filter(([status]) => !status.startsWith("2") && status !== "304");
    expect(answers.filter(([status]) => status.startsWith("2"))).toHaveLength(1);
    for (const [, { description }] of answers) expect(description).not.toBe("");
    for (const [, { content }] of refusals) {
      expect(content).toEqual({
        "application/problem+json": { schema: { $ref: "#/components/schemas/Problem" } },
      });
    }
    const later = refusals.filter(([status]) => status === "429" || status === "507");
    for (const [, { headers }] of later) expect(headers).toHaveProperty("Retry-After");
  });

  it("describes query parameters as numbers with the validated limits", () => {
    const sensors = calls.find(({ operation }) => operation.operationId === "readSensors");
    const parameterOf = (wanted: string) =>
      sensors?.parameters?.find((each) => "name" in each && each.name === wanted);
    const after = parameterOf("after");
    const wait = parameterOf("wait");
    expect(after).toMatchObject({ name: "after", required: false, schema: { type: "integer" } });
    expect(wait).toMatchObject({ name: "wait", schema: { type: "number", maximum: 25 } });
  });
});
