/** Operations on commands: send, follow, cancel, list and stop. */
import { commandRecordSchema, orderSchema } from "@corridor/protocol";
import { z } from "zod";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { limits } from "../../../platform/limits/limits.ts";
import { answer, location, parameters, refusals } from "../../../platform/openapi/parts.ts";
import {
  anyKey,
  asScript,
  driver,
  idempotencyKey,
  ofScript,
  robot,
} from "../../requests/openapi-parts.ts";
import { logQuery, seqPath, waitQuery } from "../../requests/script-requests.ts";

export const commandLogSchema = z.strictObject({
  /** in order of their numbers */
  commands: z.array(commandRecordSchema).max(limits.logPage),
});
export type CommandLog = z.infer<typeof commandLogSchema>;

export const commandCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots/{id}/commands": {
    parameters: [...robot, ...ofScript],
    post: {
      operationId: "sendCommand",
      summary: "Send a command",
      description:
        "A command that has not started within `ttl` ms (default: 10 s) ends as `expired`. A retry has the same " +
        "`Idempotency-Key`, and its `age` is the ms since the first attempt. Transit time counts only with " +
        "`Script-Clock`: see `/docs/commands#deadline`.",
      security: driver,
      parameters: idempotencyKey,
      requestBody: { required: true, content: { "application/json": { schema: orderSchema } } },
      responses: {
        202: answer("The record of the stored command.", commandRecordSchema, location),
        ...refusals(
          ...asScript,
          "key-conflict",
          "driving-paused",
          "reset-disabled",
          "too-late",
          "too-large",
          "not-json",
          "queue-full",
          "too-fast",
          "storage-full",
        ),
      },
    },
    get: {
      operationId: "listCommands",
      summary: "List the commands of a robot in their order, with their states",
      description: "Repeat with `after` set to the last `seq` for the next page.",
      security: anyKey,
      parameters: parameters("query", logQuery),
      responses: {
        200: answer("The next page of the log; empty at its end.", commandLogSchema),
        ...refusals(...asScript),
      },
    },
    delete: {
      operationId: "stopRobot",
      summary: "Stop the robot and cancel all waiting commands",
      security: driver,
      parameters: idempotencyKey,
      responses: {
        202: answer(
          "The record of the stop, which overtakes other commands.",
          commandRecordSchema,
          location,
        ),
        ...refusals(...asScript, "key-conflict", "too-late", "too-fast", "storage-full"),
      },
    },
  },
  "/api/v1/robots/{id}/commands/{seq}": {
    parameters: [...robot, ...parameters("path", seqPath), ...ofScript],
    get: {
      operationId: "followCommand",
      summary: "Read the record of a command, or wait for its end",
      security: anyKey,
      parameters: parameters("query", waitQuery),
      responses: {
        200: answer(
          "The record, when the command has ended or after `wait` seconds.",
          commandRecordSchema,
        ),
        ...refusals(...asScript, "no-command", "too-many-readers"),
      },
    },
    delete: {
      operationId: "cancelCommand",
      summary: "Cancel one command that was sent with the same key",
      description:
        "A waiting command is cancelled immediately. For a delivered command, the relay asks the robot to end it.",
      security: driver,
      responses: {
        202: answer("The current record.", commandRecordSchema, location),
        ...refusals(...asScript, "no-command", "storage-full"),
      },
    },
  },
};
