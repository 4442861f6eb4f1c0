/**
 * The AsyncAPI 3.0 description of the robot's WebSocket, generated from the schemas that validate
 * the messages. The schemas describe the fields. This module adds the direction of each message.
 */
import {
  commandRecordSchema,
  driverToRelaySchema,
  helloSchema,
  pageToRelaySchema,
  problemSchema,
  PROTOCOL_VERSION,
  relayToDriverSchema,
  relayToPageSchema,
  resumeSchema,
  snapshotSchema,
} from "@corridor/protocol";
import { z } from "zod";
import { messageExamples, type MessageKinds } from "./examples.ts";
import { CHANNEL, DESCRIPTION, MESSAGE_TEXTS, OPERATIONS } from "./texts.ts";

type Message = z.ZodType & { shape: { type: z.ZodLiteral<string> } };

/** Messages by sender. The name of a message is its side, then its type. */
const sides = {
  script: {
    action: "receive",
    messages: [helloSchema, ...driverToRelaySchema.options],
  },
  page: {
    action: "receive",
    messages: [helloSchema, resumeSchema, ...pageToRelaySchema.options],
  },
  toScript: {
    action: "send",
    messages: relayToDriverSchema.options,
  },
  toPage: {
    action: "send",
    messages: relayToPageSchema.options,
  },
} as const satisfies Record<
  keyof MessageKinds,
  { action: "send" | "receive"; messages: readonly Message[] }
>;

const shared = {
  CommandRecord: commandRecordSchema,
  Problem: problemSchema,
  Snapshot: snapshotSchema,
};

/** The document does not contain the address of the service that serves it. */
const servers = {
  service: {
    host: "{host}",
    protocol: "wss",
    description: "The service that serves this document, over https.",
    variables: {
      host: {
        default: "robots.example.org",
        description: "as in the robot's address, https://HOST/r/ID#KEY",
      },
    },
  },
  local: {
    host: "{host}",
    protocol: "ws",
    description: "The same service over http, for example on your own computer.",
    variables: { host: { default: "localhost:8080", description: "as in the robot's address" } },
  },
} as const;

/** The name of a message in the document, such as `toScriptState`. */
export function messageName(side: string, type: string): string {
  return side + type.charAt(0).toUpperCase() + type.slice(1);
}

/** Builds the document as plain data. */
export function describeMessages(): Record<string, unknown> {
  const named = Object.entries(sides).flatMap(([side, { messages }]) =>
    messages.map((schema: Message) => {
      const type = String(schema.shape.type.value);
      return { side, type, name: messageName(side, type), schema };
    }),
  );
  const payloads = schemasOf(named);
  const reference = (place: string, name: string) => ({ $ref: `#/${place}/${name}` });
  return {
    asyncapi: "3.0.0",
    info: {
      title: "Corridor",
      version: String(PROTOCOL_VERSION),
      description: DESCRIPTION,
      license: { name: "MIT" },
    },
    defaultContentType: "application/json",
    servers,
    channels: {
      robot: {
        address: "/api/v1/robots/{id}/socket",
        ...CHANNEL,
        servers: Object.keys(servers).map((name) => ({ $ref: `#/servers/${name}` })),
        parameters: { id: { description: "the 22 characters of the robot's id" } },
        messages: Object.fromEntries(
          named.map(({ name }) => [name, reference("components/messages", name)]),
        ),
      },
    },
    operations: Object.fromEntries(
      Object.entries(sides).map(([side, { action }]) => [
        side,
        {
          action,
          ...OPERATIONS[side as keyof MessageKinds],
          channel: { $ref: "#/channels/robot" },
          messages: named
            .filter((message) => message.side === side)
            .map(({ name }) => reference("channels/robot/messages", name)),
        },
      ]),
    ),
    components: {
      messages: Object.fromEntries(
        named.map(({ side, name, type }) => [
          name,
          { name: type, ...descriptionOf(side, type), payload: payloads[name] },
        ]),
      ),
      schemas: Object.fromEntries(Object.keys(shared).map((name) => [name, payloads[name]])),
    },
  };
}

/** Description and example of a message. */
function descriptionOf(side: string, type: string): object {
  const text = (MESSAGE_TEXTS as Record<string, Record<string, string>>)[side]?.[type];
  const example = (messageExamples as Record<string, Record<string, object>>)[side]?.[type];
  return { description: text, examples: [{ payload: example }] };
}

/** Converts all messages and shared parts to JSON Schema. Messages reference the shared parts. */
function schemasOf(named: readonly { name: string; schema: z.ZodType }[]): Record<string, unknown> {
  const registry = z.registry<{ id: string }>();
  for (const [id, schema] of Object.entries(shared)) registry.add(schema, { id });
  // A registry has one entry per schema, so a message of both directions is cloned.
  for (const { name, schema } of named) registry.add(schema.clone(), { id: name });
  const { schemas } = z.toJSONSchema(registry, {
    target: "draft-07",
    io: "input",
    uri: (id) => `#/components/schemas/${id}`,
  });
  return Object.fromEntries(
    Object.entries(schemas).map(([id, { $id: _id, $schema: _schema, ...schema }]) => [id, schema]),
  );
}
