import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import asyncApiSchema from "@asyncapi/specs/schemas/3.0.0-without-$id.json" with { type: "json" };
import { Ajv } from "ajv";
import { describe, expect, it } from "vitest";
import { startTestRelay } from "../../testing/test-relay.ts";
import { describeMessages, messageName } from "./document.ts";

interface Described {
  servers: Record<string, { host: string; protocol: string; description: string }>;
  channels: Record<
    "robot" | "class",
    { description: string; servers: unknown[]; messages: Record<string, unknown> }
  >;
  operations: Record<
    string,
    {
      action: string;
      summary: string;
      description: string;
      channel: { $ref: string };
      messages: { $ref: string }[];
    }
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

/** The sides that send or receive a message, by the start of the name of its fixture. */
const fixtureSides = {
  fixtures: {
    "relay-to-driver-": "toScript",
    "relay-to-page-": "toPage",
    "driver-": "script",
    "page-": "page",
  },
  "class-fixtures": {
    "relay-to-student-": "toStudent",
    "relay-to-teacher-": "toDashboard",
    "relay-to-screen-": "toBigScreen",
    "student-": "student",
    "teacher-": "dashboard",
    "screen-": "bigScreen",
  },
};

/** Each golden message, with its names in the document. */
const fixtures = Object.entries(fixtureSides).flatMap(([folder, sides]) => {
  const path = join(import.meta.dirname, "../../../../../packages/protocol/src", folder);
  return readdirSync(path).map((file) => {
    const fixture = file.replace(".json", "");
    const senders = Object.values(sides).filter((side) => !side.startsWith("to"));
    const [prefix, side] = Object.entries(sides).find(([start]) => fixture.startsWith(start)) ?? [
      "",
      "",
    ];
    const names =
      fixture === "hello"
        ? senders.map((sender) => messageName(sender, "hello"))
        : [messageName(side, fixture.slice(prefix.length))];
    const message = JSON.parse(readFileSync(join(path, file), "utf8")) as Record<string, unknown>;
    return { name: `${folder}/${fixture}`, names, message };
  });
});

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
    const names = fixtures.flatMap(({ names }) => names).toSorted();
    expect(Object.keys(document.components.messages).toSorted()).toEqual(names);
    const referenced = Object.values(document.operations).flatMap(({ messages }) => messages);
    expect(referenced.map(({ $ref }) => $ref.replace(/^.*\//, "")).toSorted()).toEqual(names);
  });

  it.each(fixtures)("describes $name as it is on the wire", ({ names, message }) => {
    for (const described of names) {
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

  it("lists a server for each scheme of an address", () => {
    const { servers, channels } = document;
    expect(Object.values(servers).map(({ protocol }) => protocol)).toEqual(["wss", "ws"]);
    for (const { description } of Object.values(servers)) expect(description).not.toBe("");
    for (const { servers: used } of Object.values(channels)) expect(used).toHaveLength(2);
  });

  it("describes the order of messages of each side, and mentions existing messages only", () => {
    const types = new Set(Object.values(document.components.messages).map(({ name }) => name));
    const others = new Set(["key", "n", "learn", "teach", "show"]);
    for (const { summary, description, channel } of Object.values(document.operations)) {
      expect(summary).toMatch(/\.$/);
      const named = [...description.matchAll(/`(\w+)`/g)].map(([, word]) => word ?? "");
      expect(named[0]).toBe("hello");
      expect(named.find((word) => ["welcome", "command", "tile", "tiles"].includes(word))).toBe(
        "welcome",
      );
      expect(named.filter((word) => !types.has(word) && !others.has(word))).toEqual([]);
      const name = channel.$ref.replace("#/channels/", "");
      expect(document.channels[name === "robot" ? name : "class"].description).toContain(
        description,
      );
    }
  });
});
