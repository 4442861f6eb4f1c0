/**
 * The AsyncAPI 3.0 description of the WebSockets of robots and classes, generated from the schemas
 * that validate the messages. The schemas describe the fields. This module adds the direction of
 * each message.
 */
import {
  classHelloSchema,
  classSettingsSchema,
  commandRecordSchema,
  driverToRelaySchema,
  helloSchema,
  pageToRelaySchema,
  problemSchema,
  progressSchema,
  PROTOCOL_VERSION,
  relayToDriverSchema,
  relayToPageSchema,
  relayToScreenSchema,
  relayToStudentSchema,
  relayToTeacherSchema,
  resumeSchema,
  screenToRelaySchema,
  snapshotSchema,
  studentToRelaySchema,
  teacherToRelaySchema,
  tileSchema,
  untilConditionSchema,
} from "@corridor/protocol";
import { z } from "zod";
import { classMessageExamples, type ClassMessageKinds } from "./class-examples.ts";
import { classTexts } from "./class-texts.ts";
import { messageExamples, type MessageKinds } from "./examples.ts";
import { DESCRIPTION, robotTexts } from "./texts.ts";

type Message = z.ZodType & { shape: { type: z.ZodLiteral<string> } };
type Sides<K> = Record<keyof K, { action: "send" | "receive"; messages: readonly Message[] }>;

/** Messages of a robot by sender. The name of a message is its side, then its type. */
const robotSides: Sides<MessageKinds> = {
  script: { action: "receive", messages: [helloSchema, ...driverToRelaySchema.options] },
  page: { action: "receive", messages: [helloSchema, resumeSchema, ...pageToRelaySchema.options] },
  toScript: { action: "send", messages: relayToDriverSchema.options },
  toPage: { action: "send", messages: relayToPageSchema.options },
};

/** Messages of a class by sender. */
const classSides: Sides<ClassMessageKinds> = {
  student: { action: "receive", messages: [classHelloSchema, ...studentToRelaySchema.options] },
  dashboard: { action: "receive", messages: [classHelloSchema, ...teacherToRelaySchema.options] },
  bigScreen: { action: "receive", messages: [classHelloSchema, ...screenToRelaySchema.options] },
  toStudent: { action: "send", messages: relayToStudentSchema.options },
  toDashboard: { action: "send", messages: relayToTeacherSchema.options },
  toBigScreen: { action: "send", messages: relayToScreenSchema.options },
};

const channels = [
  {
    channel: "robot",
    address: "/api/v1/robots/{id}/socket",
    id: "the 22 characters of the robot's id",
    sides: robotSides,
    texts: robotTexts,
    examples: messageExamples,
  },
  {
    channel: "class",
    address: "/api/v1/classes/{id}/socket",
    id: "the 22 characters of the class's id",
    sides: classSides,
    texts: classTexts,
    examples: classMessageExamples,
  },
];

const shared = {
  ClassSettings: classSettingsSchema,
  CommandRecord: commandRecordSchema,
  Problem: problemSchema,
  Progress: progressSchema,
  Snapshot: snapshotSchema,
  Tile: tileSchema,
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

interface Described {
  channel: string;
  side: string;
  type: string;
  name: string;
  schema: z.ZodType;
  description: string | undefined;
  example: object | undefined;
}

/** All messages of a channel, with description and example. */
function messagesOf({ channel, sides, texts, examples }: (typeof channels)[number]): Described[] {
  const described = new Map<string, Record<string, string>>(Object.entries(texts.messages));
  const shown = new Map<string, Record<string, object>>(Object.entries(examples));
  return Object.entries(sides).flatMap(([side, { messages }]) =>
    messages.map((schema) => {
      const type = String(schema.shape.type.value);
      const name = messageName(side, type);
      const description = described.get(side)?.[type];
      return { channel, side, type, name, schema, description, example: shown.get(side)?.[type] };
    }),
  );
}

/** Builds the document as plain data. */
export function describeMessages(): Record<string, unknown> {
  const messages = channels.flatMap(messagesOf);
  const payloads = schemasOf(messages);
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
    channels: Object.fromEntries(
      channels.map(({ channel, address, id, texts }) => [
        channel,
        {
          address,
          ...texts.channel,
          servers: Object.keys(servers).map((name) => reference("servers", name)),
          parameters: { id: { description: id } },
          messages: Object.fromEntries(
            messages
              .filter((message) => message.channel === channel)
              .map(({ name }) => [name, reference("components/messages", name)]),
          ),
        },
      ]),
    ),
    operations: Object.fromEntries(
      channels.flatMap(({ channel, sides, texts }) => {
        const operations = new Map<string, object>(Object.entries(texts.operations));
        return Object.entries(sides).map(([side, { action }]) => [
          side,
          {
            action,
            ...operations.get(side),
            channel: reference("channels", channel),
            messages: messages
              .filter((message) => message.side === side)
              .map(({ name }) => reference(`channels/${channel}/messages`, name)),
          },
        ]);
      }),
    ),
    components: {
      messages: Object.fromEntries(
        messages.map(({ name, type, description, example }) => [
          name,
          { name: type, description, examples: [{ payload: example }], payload: payloads[name] },
        ]),
      ),
      schemas: Object.fromEntries(Object.keys(shared).map((name) => [name, payloads[name]])),
    },
  };
}

/** Conditions have a custom parser. This describes the expected value. */
function conditionShape(): object {
  const { $schema: _schema, ...shape } = z.toJSONSchema(untilConditionSchema.def.out, {
    target: "draft-07",
  });
  return shape;
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
    override: ({ zodSchema, jsonSchema }) => {
      if (zodSchema === untilConditionSchema) Object.assign(jsonSchema, conditionShape());
    },
  });
  return Object.fromEntries(
    Object.entries(schemas).map(([id, { $id: _id, $schema: _schema, ...schema }]) => [id, schema]),
  );
}
