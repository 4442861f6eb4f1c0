/**
 * The AsyncAPI 3.0 description of the robot's WebSocket, generated from the schemas that check the
 * messages. What a field must be is said by its schema alone; here is only who says what to whom.
 */
import {
  closeReasons,
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

const DESCRIPTION = `One WebSocket for each page and each script of a robot. Its first message, within 5 s, is
\`hello\`: a page goes on with \`resume\`. The relay answers with \`welcome\`. Each message is one JSON text of at most
16 KiB. Where no WebSocket passes, the same messages go by plain HTTPS: see \`/line\` in \`/openapi.json\`.`;

type Message = z.ZodType & { shape: { type: z.ZodLiteral<string> } };

/** Who says what to whom. A message's name is the side's, then its type. */
const sides = {
  script: {
    summary: "A script says hello, sends commands, and says which snapshots it has read.",
    action: "receive",
    messages: [helloSchema, ...driverToRelaySchema.options],
  },
  page: {
    summary: "A page says hello, what it has done so far, and then what the robot does.",
    action: "receive",
    messages: [helloSchema, resumeSchema, ...pageToRelaySchema.options],
  },
  toScript: {
    summary: "A script hears records, states and snapshots, and of another maze.",
    action: "send",
    messages: relayToDriverSchema.options,
  },
  toPage: {
    summary: "A page hears what the robot is to do.",
    action: "send",
    messages: relayToPageSchema.options,
  },
} as const satisfies Record<
  string,
  { summary: string; action: "send" | "receive"; messages: readonly Message[] }
>;

const shared = {
  CommandRecord: commandRecordSchema,
  Problem: problemSchema,
  Snapshot: snapshotSchema,
};

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
    channels: {
      robot: {
        address: "/api/v1/robots/{id}/socket",
        description: closeCodes(),
        parameters: { id: { description: "the 22 characters of the robot's id" } },
        messages: Object.fromEntries(
          named.map(({ name }) => [name, reference("components/messages", name)]),
        ),
      },
    },
    operations: Object.fromEntries(
      Object.entries(sides).map(([side, { action, summary }]) => [
        side,
        {
          action,
          summary,
          channel: { $ref: "#/channels/robot" },
          messages: named
            .filter((message) => message.side === side)
            .map(({ name }) => reference("channels/robot/messages", name)),
        },
      ]),
    ),
    components: {
      messages: Object.fromEntries(
        named.map(({ name, type }) => [name, { name: type, payload: payloads[name] }]),
      ),
      schemas: Object.fromEntries(Object.keys(shared).map((name) => [name, payloads[name]])),
    },
  };
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

function closeCodes(): string {
  const lines = Object.values(closeReasons).map(
    ({ code, cause, retry }) => `- ${code}: ${cause}${retry ? "" : " (do not try again)"}`,
  );
  return ["Close codes:", ...lines].join("\n");
}
