import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import asyncApiSchema from "@asyncapi/specs/schemas/3.0.0-without-$id.json" with { type: "json" };
import { Ajv } from "ajv";
import { describe, expect, it } from "vitest";
import { startTestRelay } from "../../testing/test-relay.ts";
import { describeMessages, messageName } from "./document.ts";

interface Described {
  servers: Record<string, { host: string; protocol: string; description: string }>;
  channels: {
    robot: { description: string; servers: unknown[]; messages: Record<string, unknown> };
  };
  operations: Record<
    string,
    { action: string; summary: string; description: string; messages: { $ref: string }[] }
  >;
  components: {
    messages: Record<
      string,
      { name: string; description: string; payload: object; examples: { payload: object }[] }
    >;
    schemas: Record<string, object>;
  };
}

const document = describeMessages() as unknown as Described;
const text = JSON.stringify(document);

/** Names in the document of the message in a fixture file. */
function nameOf(fixture: string): string[] {
  if (fixture === "hello") return [messageName("script", "hello"), messageName("page", "hello")];
  const sides = {
    "relay-to-driver-": "toScript",
    "relay-to-page-": "toPage",
    "driver-": "script",
    "page-": "page",
  };
  const [prefix, side] = Object.entries(sides).find(([start]) => fixture.startsWith(start)) ?? [
    "",
    "",
  ];
  return [messageName(side, fixture.slice(prefix.length))];
}

const FIXTURES = join(import.meta.dirname, "../../../../../packages/protocol/src/fixtures");
const fixtures = readdirSync(FIXTURES).map((file) => ({
  name: file.replace(".json", ""),
  message: JSON.parse(readFileSync(join(FIXTURES, file), "utf8")) as Record<string, unknown>,
}));

function validatorOf(name: string) {
  const ajv = new Ajv({ strict: false, validateFormats: false });
  const { payload } = document.components.messages[name] ?? { payload: { not: {} } };
  return ajv.compile({ ...payload, components: document.components });
}

describe("/asyncapi.json", () => {
  it("is AsyncAPI 3.0, by its official schema", () => {
    const ajv = new Ajv({ strict: false, validateFormats: false, allErrors: true });
    const validate = ajv.compile(asyncApiSchema);
    expect(validate(JSON.parse(text)) ? [] : validate.errors).toEqual([]);
    expect(validate({ ...(document as object), channels: [] })).toBe(false);
  });

  it("is served with CORS headers for every site", async () => {
    const { origin } = await startTestRelay();
    const answer = await fetch(`${origin}/asyncapi.json`);
    expect(answer.headers.get("access-control-allow-origin")).toBe("*");
    expect(await answer.text()).toBe(text);
  });

  it("resolves every reference", () => {
    const references = [...text.matchAll(/"\$ref":"([^"]+)"/g)].map(([, path]) => path ?? "");
    expect(references.length).toBeGreaterThan(30);
    const missing = references.filter((path) => {
      const parts = path.slice(2).split("/");
      const found = parts.reduce<unknown>(
        (node, part) => (node as Record<string, unknown> | undefined)?.[part],
        document,
      );
      return !path.startsWith("#/") || typeof found !== "object";
    });
    expect(missing).toEqual([]);
  });

  it("contains every message exactly once, and no other", () => {
    const names = fixtures.flatMap(({ name }) => nameOf(name)).toSorted();
    expect(Object.keys(document.components.messages).toSorted()).toEqual(names);
    const referenced = Object.values(document.operations).flatMap(({ messages }) => messages);
    expect(referenced.map(({ $ref }) => $ref.replace(/^.*\//, "")).toSorted()).toEqual(names);
  });

  it.each(fixtures)("describes $name as it is on the wire", ({ name, message }) => {
    for (const described of nameOf(name)) {
      const validate = validatorOf(described);
      expect(validate(message) ? [] : validate.errors).toEqual([]);
      expect(validate({ ...message, extra: 1 })).toBe(false);
      expect(validate({ ...message, type: "another" })).toBe(false);
    }
  });

  it.each(Object.entries(document.components.messages))(
    "describes %s in a sentence, with a valid example",
    (name, { name: type, description, examples }) => {
      expect(description).toMatch(/^[A-Z].{20,}\.$/);
      expect(examples.length).toBeGreaterThan(0);
      const validate = validatorOf(name);
      for (const { payload } of examples) {
        expect(validate(payload) ? [] : validate.errors).toEqual([]);
        expect(payload).toMatchObject({ type });
      }
    },
  );

  it("lists a server for each scheme of a robot's address", () => {
    const { servers, channels } = document;
    expect(Object.values(servers).map(({ protocol }) => protocol)).toEqual(["wss", "ws"]);
    for (const { description } of Object.values(servers)) expect(description).not.toBe("");
    expect(channels.robot.servers).toHaveLength(2);
  });

  it("describes the order of messages of each side, and mentions existing messages only", () => {
    const types = new Set(Object.values(document.components.messages).map(({ name }) => name));
    const fields = new Set(["key", "n"]);
    for (const { summary, description } of Object.values(document.operations)) {
      expect(summary).toMatch(/\.$/);
      const named = [...description.matchAll(/`(\w+)`/g)].map(([, word]) => word ?? "");
      expect(named[0]).toBe("hello");
      expect(named.indexOf("welcome")).toBeGreaterThan(0);
      expect(named.indexOf("welcome")).toBeLessThan(named.indexOf("command"));
      expect(named.filter((word) => !types.has(word) && !fields.has(word))).toEqual([]);
      expect(document.channels.robot.description).toContain(description);
    }
  });
});
