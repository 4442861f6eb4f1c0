/**
 * Operations for scripts and watchers: read the robot and its maze, send commands, follow their
 * states.
 */
import {
  commandRecordSchema,
  eventPageSchema,
  orderSchema,
  snapshotSchema,
} from "@corridor/protocol";
import { mazeSchema } from "@corridor/maze";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { commandLogSchema } from "../../requests/answers.ts";
import { ifNoneMatchHeader } from "../maze/routes.ts";
import {
  clockHeader,
  eventsQuery,
  idempotencyHeader,
  lastEventHeader,
  logQuery,
  nameHeader,
  newerQuery,
  seqPath,
  waitQuery,
} from "../../requests/reading.ts";
import {
  answer,
  asScript,
  entityTag,
  keyed,
  location,
  owner,
  parameters,
  refusals,
  robot,
} from "../../../platform/openapi/parts.ts";
import { streamedEventSchema } from "../../sse/streamed-event.ts";

const idempotencyKey = parameters("header", idempotencyHeader);
/** headers with which a script identifies itself */
const ofScript = [...parameters("header", nameHeader), ...parameters("header", clockHeader)];
const driver = [{ driverKey: [] }];
const reader = [{ driverKey: [] }, { watchKey: [] }];
const logReader = [...reader, { ownerKey: [] }];

export const scriptCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots/{id}/sensors": {
    parameters: [...robot, ...ofScript],
    get: {
      operationId: "readSensors",
      summary: "Read the newest snapshot, or wait for a newer one",
      description:
        "With `after` and `wait`, the relay responds as soon as it has a snapshot with a higher `seq`, or " +
        "with the newest snapshot after `wait` seconds.",
      security: reader,
      parameters: parameters("query", newerQuery),
      responses: {
        200: answer("The newest snapshot.", snapshotSchema),
        ...refusals(...asScript, "no-snapshot", "too-many-readers"),
      },
    },
  },
  "/api/v1/robots/{id}/maze": {
    parameters: robot,
    get: {
      operationId: "readMaze",
      summary: "Read the maze of the robot",
      description:
        "The response is the maze that the robot's page published. When it changes, readers receive a `maze` message or " +
        "event with the new `ETag` as `version`.",
      security: logReader,
      parameters: [...ofScript, ...parameters("header", ifNoneMatchHeader)],
      responses: {
        200: answer("The maze.", mazeSchema, entityTag),
        304: { description: "The cached maze is current.", headers: entityTag },
        ...refusals(...asScript, "no-maze"),
      },
    },
    put: {
      operationId: "publishMaze",
      summary: "Publish the maze of the robot (used by its page)",
      description:
        "The maze replaces the previous one, and is deleted with the robot. An equal maze " +
        "changes nothing. A robot can publish one maze a second, with bursts of 20.",
      security: owner,
      requestBody: { required: true, content: { "application/json": { schema: mazeSchema } } },
      responses: {
        204: { description: "The maze is stored.", headers: entityTag },
        ...refusals(...keyed, "too-large", "not-json", "too-fast", "storage-full"),
      },
    },
  },
  "/api/v1/robots/{id}/commands": {
    parameters: [...robot, ...ofScript],
    post: {
      operationId: "sendCommand",
      summary: "Send a command",
      description:
        "A command that has not started within `ttl` ms (default: 10 s) ends as `expired`. Send a " +
        "retry with the same `Idempotency-Key` and its `age`, the ms since the first attempt. Transit time counts only " +
        "with `Script-Clock`: see `/docs/commands#deadline`.",
      security: driver,
      parameters: idempotencyKey,
      requestBody: { required: true, content: { "application/json": { schema: orderSchema } } },
      responses: {
        202: answer("The record of the stored command.", commandRecordSchema, location),
        ...refusals(
          ...asScript,
          "key-conflict",
          "driving-paused",
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
      security: logReader,
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
        ...refusals(...asScript, "key-conflict", "too-fast", "storage-full"),
      },
    },
  },
  "/api/v1/robots/{id}/commands/{seq}": {
    parameters: [...robot, ...parameters("path", seqPath), ...ofScript],
    get: {
      operationId: "followCommand",
      summary: "Read the record of a command, or wait for its end",
      security: logReader,
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
  "/api/v1/robots/{id}/events": {
    parameters: [...robot, ...ofScript],
    get: {
      operationId: "followEvents",
      summary: "Follow a robot by server-sent events, or by long polling",
      description:
        "Without `wait`: an endless stream of events. `snapshot` contains a Snapshot; `state` contains " +
        "the CommandRecord of a command with a new state; `gap` replaces states that are no longer stored; " +
        "`maze` reports another maze. Send the `id` of the last event as `Last-Event-ID` or `since` to resume there.\n\n" +
        "With `wait`: one response, as soon as there is a state after `since` or a snapshot newer than " +
        "`after`. Send the first request without `since`, then each with the `since` of the previous response. The " +
        "newest 1,000 states are stored, for 10 minutes.",
      security: reader,
      parameters: [...parameters("query", eventsQuery), ...parameters("header", lastEventHeader)],
      responses: {
        200: {
          description: "An endless stream or, with `wait`, the pending events.",
          content: {
            "application/json": { schema: eventPageSchema },
            // Before OpenAPI 3.2, which has `itemSchema`, the schema of a stream describes one
            // event.
            "text/event-stream": { schema: streamedEventSchema },
          },
        },
        ...refusals(...asScript, "too-many-readers"),
      },
    },
  },
};
