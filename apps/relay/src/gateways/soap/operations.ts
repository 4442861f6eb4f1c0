/** The operations of the SOAP service. Their shapes are those of the API. */
import {
  commandRecordSchema,
  idempotencyKeySchema,
  orderSchema,
  problemSchema,
  readValue,
  sendAndWait,
  snapshotSchema,
  untilConditionSchema,
  type Order,
  type RobotPort,
} from "@corridor/protocol";
import type { Response } from "express";
import { z } from "zod";
import { badRequest } from "../../platform/errors/problems.ts";
import { countSchema, read, waitSeconds } from "../../platform/http/reading.ts";
import type { Verb } from "../../robots/access/callers.ts";
import type { Grant } from "../../robots/registry.ts";
import { withCommandHint } from "../requests/command-hints.ts";
import { readSnapshot } from "../requests/script-requests.ts";
import { commandLogSchema } from "../rest/commands/openapi.ts";
import type { XmlElement } from "./read-xml.ts";
import { joined, shapeOf, type ObjectShape, type TypeNames } from "./shape.ts";
import { readFields } from "./values.ts";

/** What an operation works with. */
export interface Call {
  grant: Grant;
  port: RobotPort;
  response: Response;
  /** ms since the request arrived */
  ageMs: () => number;
}

export interface Operation {
  /** for the WSDL */
  description: string;
  verb: Verb;
  request: ObjectShape;
  response: ObjectShape;
  /**
   * Reads the fields.
   * @returns a function that answers; it throws a Refusal or a RefusedError
   * @throws Refusal bad-request
   */
  read(source: XmlElement): (call: Call) => Promise<object>;
}

const names: TypeNames = z.registry();
names.add(snapshotSchema.shape.pose, { id: "Pose" });
names.add(snapshotSchema.shape.sensors, { id: "SensorReadings" });
names.add(untilConditionSchema, { id: "UntilCondition" });
names.add(commandRecordSchema, { id: "CommandRecord" });
names.add(commandRecordSchema.shape.command, { id: "RecordedCommand" });
names.add(problemSchema.shape.errors.element, { id: "FieldProblem" });

const addressed = shapeOf(
  z.strictObject({
    robot: z
      .string()
      .describe(
        "the address of the robot, as copied from its page; without its key if the header Authorization contains it",
      ),
  }),
  names,
);

const record = shapeOf(commandRecordSchema, names);

/** The detail of a fault. */
export const faultShape = shapeOf(
  z.strictObject({
    code: z.string().describe("the kind of problem, such as no-robot; an open list"),
    detail: problemSchema.shape.detail.describe("what happened and how to fix it"),
    retryAfter: z
      .int()
      .min(0)
      .optional()
      .describe("seconds after which the same request may succeed"),
    errors: problemSchema.shape.errors,
  }),
  names,
);

const wait = waitSeconds
  .optional()
  .describe("seconds to wait for a result, from 0 to 25; default: 0");
const seq = countSchema.describe("number of the command");
const key = idempotencyKeySchema
  .optional()
  .describe(
    "idempotency key, 8 to 64 of A-Z a-z 0-9 - _: the same key never runs twice; a new one for each command",
  );
const sending = z.strictObject({ key, wait });

/** Without a wait, the answer is immediate. */
const toMs = (seconds = 0): number => seconds * 1000;

function operation<T>(parts: {
  description: string;
  verb: Verb;
  fields: z.ZodType<T>;
  response: ObjectShape;
  run: (call: Call, fields: T) => Promise<object>;
}): Operation {
  const { description, verb, fields, response, run } = parts;
  const request = joined(addressed, shapeOf(fields, names));
  return {
    description,
    verb,
    request,
    response,
    read: (source) => {
      const { robot: _, ...values } = readFields(source, request);
      const value = read(fields, values, "Invalid message.");
      return (call) => run(call, value);
    },
  };
}

const commandRequest = joined(addressed, shapeOf(orderSchema, names), shapeOf(sending, names));

/** By the names of their elements. */
export const operations: Readonly<Record<string, Operation>> = {
  Sense: operation({
    description:
      "Reads the newest snapshot: sensors, pose, motion and goals. With after and wait, waits for a newer one.",
    verb: "read",
    fields: z.strictObject({
      after: countSchema.optional().describe("seq of the last received snapshot"),
      wait,
    }),
    response: shapeOf(snapshotSchema, names),
    run: async ({ grant, response }, fields) =>
      readSnapshot(grant, { after: fields.after, wait: fields.wait ?? 0 }, response),
  }),
  Command: {
    description: "Sends one command, and with wait waits for its end.",
    verb: "command",
    request: commandRequest,
    response: record,
    read: (source) => {
      const fields = readFields(source, commandRequest);
      const { robot: _, key: sentKey, wait: sentWait, ...order } = fields;
      const terms = read(sending, { key: sentKey, wait: sentWait }, "Invalid command.");
      const command = readOrder(order);
      return async (call) => send(call, command, terms);
    },
  },
  GetCommand: operation({
    description: "Reads the record of one command, and with wait waits for its end.",
    verb: "log",
    fields: z.strictObject({ seq, wait }),
    response: record,
    run: async ({ port }, fields) => port.endOf(fields.seq, toMs(fields.wait)),
  }),
  GetCommands: operation({
    description: "Lists the records of commands, in order of their numbers.",
    verb: "log",
    fields: z.strictObject({
      after: countSchema.optional().describe("seq of the last received command; default: 0"),
    }),
    response: shapeOf(commandLogSchema, names),
    // Ports have no log, because other protocols do not read it.
    run: async ({ grant }, { after = 0 }) => ({
      commands: await grant.robot.commandsAfter(after),
    }),
  }),
  CancelCommand: operation({
    description: "Cancels one command of the same key.",
    verb: "command",
    fields: z.strictObject({ seq }),
    response: record,
    run: async ({ port }, fields) => port.cancel(fields.seq),
  }),
  Stop: operation({
    description: "Stops the robot at once, and cancels all commands that run or wait.",
    verb: "command",
    fields: sending,
    response: record,
    run: async (call, terms) => send(call, { action: "stop" }, terms),
  }),
};

/** @throws Refusal bad-request */
function readOrder(value: unknown): Order {
  const result = readValue(orderSchema, value);
  if (result.ok) return result.value;
  throw badRequest("Invalid command.", withCommandHint(value, result.problems));
}

async function send(
  { port, ageMs }: Call,
  order: Order,
  terms: z.infer<typeof sending>,
): Promise<object> {
  const aged = { ...order, age: (order.age ?? 0) + ageMs() };
  return sendAndWait(port, aged, terms.key, toMs(terms.wait));
}
