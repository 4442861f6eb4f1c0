/**
 * The AsyncAPI 3.0 description of the robot's WebSocket, generated from the schemas that check the
 * messages. What a field must be is said by its schema alone; here is only who says what to whom.
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
import { CHANNEL, DESCRIPTION, MESSAGE_WORDS, OPERATIONS } from "./words.ts";

type Message = z.ZodType & { shape: { type: z.ZodLiteral<string> } };

/** Who says what to whom. A message's name is the side's, then its type. */
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

/** The document knows no address of its own: the service that it comes from is the one. */
const servers = {
  service: {
    host: "{host}",
    protocol: "wss",
    description: "The service that this document comes from, where its pages are at https.",
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
    description: "The same where the robot's address begins with http, as on one's own computer.",
    variables: { host: { default: "localhost:8080", description: "as in the robot's address" } },
  },
} as const;

/** The name of a message in the document, such as `toScriptState`. */
export function messageName(side: string, type: string): string {
  return side + type.charAt(0).toUpperCase() + type.slice(1);
}

/** The whole document, as plain data. */
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
          { name: type, ...aidsOf(side, type), payload: payloads[name] },
        ]),
      ),
      schemas: Object.fromEntries(Object.keys(shared).map((name) => [name, payloads[name]])),
    },
  };
}

/** What a message is for, and one as it is. */
function aidsOf(side: string, type: string): object {
  const words = (MESSAGE_WORDS as Record<string, Record<string, string>>)[side]?.[type];
  const example = (messageExamples as Record<string, Record<string, object>>)[side]?.[type];
  return { description: words, examples: [{ payload: example }] };
}

/** Every message and every shared part as JSON Schema; the shared ones are referred to. */
function schemasOf(named: readonly { name: string; schema: z.ZodType }[]): Record<string, unknown> {
  const registry = z.registry<{ id: string }>();
  for (const [id, schema] of Object.entries(shared)) registry.add(schema, { id });
  // The same message in two directions would be one entry of the registry, but needs two names.
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
