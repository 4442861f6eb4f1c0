import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { messageTexts } from "./interface-texts.ts";
import { isObject, readMessage, type Message } from "./read-message.ts";
import { RosError } from "./ros-error.ts";
import { RosClient } from "./testing/ros-client.ts";
import { topics } from "./topics.ts";

const types = Object.keys(messageTexts);
const names = [
  "linear",
  "angular",
  "x",
  "y",
  "z",
  "twist",
  "header",
  "stamp",
  "sec",
  "nsecs",
  "msg",
];
/** JSON with the field names of real messages, and with those that harm careless readers. */
const json = fc.letrec((again) => ({
  value: fc.oneof(
    { maxDepth: 4 },
    fc.jsonValue(),
    fc.constantFrom("now", 1e308, -0, "__proto__", null),
    fc.array(again("value"), { maxLength: 4 }),
    fc.dictionary(
      fc.oneof(fc.constantFrom(...names, "__proto__", "constructor", "toString"), fc.string()),
      again("value"),
      { maxKeys: 4 },
    ),
  ),
})).value;

function isFiniteEverywhere(value: unknown): boolean {
  if (typeof value === "number") return Number.isFinite(value);
  if (Array.isArray(value)) return value.every(isFiniteEverywhere);
  return !isObject(value) || Object.values(value).every(isFiniteEverywhere);
}

/** @returns the message, or the sentence with which it is refused */
function readOrRefuse(type: string, value: unknown): Message | string {
  try {
    return readMessage(type, value);
  } catch (error) {
    if (error instanceof RosError) return error.message;
    throw error;
  }
}

describe("a message of a client", () => {
  it("is complete and finite, or refused with a sentence", () => {
    fc.assert(
      fc.property(fc.constantFrom(...types), json, (type, value) => {
        const read = readOrRefuse(type, value);
        expect(isFiniteEverywhere(read)).toBe(true);
        // A refused message stays the sentence.
        const again = typeof read === "string" ? read : readMessage(type, read);
        expect(again).toEqual(read);
        expect(JSON.stringify(again)).toMatch(/[.}]"?$/);
      }),
      { numRuns: 1_000 },
    );
  });

  it.each(types)("%s has a default for each field", (type) => {
    const message = readMessage(type, {});
    expect(readMessage(type, message)).toEqual(message);
    expect(isFiniteEverywhere(message)).toBe(true);
  });

  it.each(Object.entries(topics).filter(([, { type }]) => type !== "rcl_interfaces/Log"))(
    "%s of ours is one that we can read",
    async (topic, { type }) => {
      const client = await RosClient.connect();
      await client.send({ op: "subscribe", topic });
      const [message] = client.received(topic);
      expect(message).toMatchObject(readMessage(type, message));
    },
  );
});

describe("a session", () => {
  const operations = [
    "advertise",
    "unadvertise",
    "publish",
    "subscribe",
    "unsubscribe",
    "call_service",
    "send_action_goal",
    "cancel_action_goal",
    "set_level",
    "auth",
  ];
  const nameOf = fc.constantFrom(
    "/cmd_vel",
    "cmd_vel",
    "/odom",
    "/stop",
    "/move",
    "do",
    "__proto__",
  );

  it("continues after any message", async () => {
    const message = fc.record(
      {
        op: fc.constantFrom(...operations),
        topic: nameOf,
        service: nameOf,
        action: nameOf,
        id: fc.oneof(fc.string(), fc.integer(), json),
        type: fc.oneof(fc.constantFrom(...types), json),
        msg: json,
        args: json,
        throttle_rate: json,
        level: fc.constantFrom("info", "none", "all"),
      },
      { requiredKeys: ["op"] },
    );
    await fc.assert(
      fc.asyncProperty(fc.array(fc.oneof(message, json), { maxLength: 20 }), async (messages) => {
        const client = await RosClient.connect();
        for (const each of messages) client.session.receive(JSON.stringify(each) ?? "");
        await client.timers.pass(500);
        expect(client.failures).toEqual([]);
        expect(await client.call("/rosapi/nodes")).toMatchObject({ result: true });
      }),
      { numRuns: 200 },
    );
  });
});
