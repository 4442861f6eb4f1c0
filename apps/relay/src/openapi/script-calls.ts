/** The HTTP calls of scripts and watchers: read the robot and its maze, send commands, follow what becomes of them. */
import {
  commandRecordSchema,
  eventPageSchema,
  orderSchema,
  snapshotSchema,
} from "@corridor/protocol";
import { mazeSchema } from "@corridor/maze";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { commandLogSchema } from "../routes/answers.ts";
import { ifNoneMatchHeader } from "../routes/maze.ts";
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
} from "../routes/reading.ts";
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
} from "./parts.ts";
import { streamedEventSchema } from "./streamed-event.ts";

const idempotencyKey = parameters("header", idempotencyHeader);
/** what every request of a script may say of itself */
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
        "With `after` and `wait`, answers as soon as there is a snapshot with a higher `seq`, and " +
        "with the newest there is when the time is over.",
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
      summary: "Read the maze that the robot is in",
      description:
        "The document as the robot's page gave it. Who follows the robot is told of another one by a `maze` " +
        "message or event, whose `version` is the new `ETag`.",
      security: logReader,
      parameters: [...ofScript, ...parameters("header", ifNoneMatchHeader)],
      responses: {
        200: answer("The maze.", mazeSchema, entityTag),
        304: { description: "It is the one that is known already.", headers: entityTag },
        ...refusals(...asScript, "no-maze"),
      },
    },
    put: {
      operationId: "keepMaze",
      summary: "Give the maze that the robot is in; its page does this",
      description:
        "It is kept with the robot in the place of the one before, and deleted with it. The same maze again " +
        "changes nothing. A robot may give one a second, 20 at once.",
      security: owner,
      requestBody: { required: true, content: { "application/json": { schema: mazeSchema } } },
      responses: {
        204: { description: "It is kept.", headers: entityTag },
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
        "One that has not started within `ttl` ms (10 s where nothing is said) ends as `expired`. Send a " +
        "retry with the same key and with its `age`, the ms since the first try. Time on the way counts only with " +
        "`Script-Clock`: with it, and with the smallest round trip in `age`, a command never runs late.",
      security: driver,
      parameters: idempotencyKey,
      requestBody: { required: true, content: { "application/json": { schema: orderSchema } } },
      responses: {
        202: answer("The record of the command, which is stored.", commandRecordSchema, location),
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
      description: "Ask again with `after` set to the last `seq` for the next part.",
      security: logReader,
      parameters: parameters("query", logQuery),
      responses: {
        200: answer("The next part of the log; empty at its end.", commandLogSchema),
        ...refusals(...asScript),
      },
    },
    delete: {
      operationId: "stopRobot",
      summary: "Drop what waits and stop the robot",
      security: driver,
      parameters: idempotencyKey,
      responses: {
        202: answer("The record of the stop, which overtakes.", commandRecordSchema, location),
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
        200: answer("The record, at its end or when the time is over.", commandRecordSchema),
        ...refusals(...asScript, "no-command", "too-many-readers"),
      },
    },
    delete: {
      operationId: "cancelCommand",
      summary: "Take back one command that was sent with the same key",
      description: "What waits is cancelled at once; for what the robot has, the robot is asked.",
      security: driver,
      responses: {
        202: answer("The record, as it is now.", commandRecordSchema, location),
        ...refusals(...asScript, "no-command", "storage-full"),
      },
    },
  },
  "/api/v1/robots/{id}/events": {
    parameters: [...robot, ...ofScript],
    get: {
      operationId: "followEvents",
      summary: "Follow a robot by server-sent events, or by long poll",
      description:
        "Without `wait`: events without end. `snapshot`, whose data is a Snapshot; `state`, whose data is " +
        "the CommandRecord of a command with a new state; `gap` in place of states that are not kept any " +
        "more; `maze` when the robot is in another one. The `id` of the last event, sent as `Last-Event-ID` or `since`, goes on from there.\n\n" +
        "With `wait`: one answer, as soon as there is a state after `since` or a snapshot newer than " +
        "`after`. Ask first without `since`, then each time with the `since` of the answer before. The " +
        "newest 1,000 states are kept, for 10 minutes.",
      security: reader,
      parameters: [...parameters("query", eventsQuery), ...parameters("header", lastEventHeader)],
      responses: {
        200: {
          description: "Events without end or, with `wait`, those that there are.",
          content: {
            "application/json": { schema: eventPageSchema },
            // Before OpenAPI 3.2, which has `itemSchema`, the schema of a stream describes one event.
            "text/event-stream": { schema: streamedEventSchema },
          },
        },
        ...refusals(...asScript, "too-many-readers"),
      },
    },
  },
};
