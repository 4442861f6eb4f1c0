/** Every HTTP call of the API, in words, with the schemas that check what goes in and what comes out. */
import {
  commandRecordSchema,
  eventPageSchema,
  orderSchema,
  fetchedMessagesSchema,
  helloSchema,
  keyListSchema,
  keyWishSchema,
  madeKeySchema,
  openedLineSchema,
  registrationSchema,
  robotIdSchema,
  sentMessagesSchema,
  shortLinkIdSchema,
  shortLinkSchema,
  snapshotSchema,
  scriptListSchema,
  scriptRefSchema,
  sentAwaySchema,
  takenMessagesSchema,
} from "@corridor/protocol";
import { mazeSchema } from "@corridor/maze";
import { z } from "zod";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { documentSchema } from "../documents/document-schema.ts";
import {
  commandLogSchema,
  healthSchema,
  heldSessionSchema,
  readySchema,
} from "../routes/answers.ts";
import {
  eventsQuery,
  fetchQuery,
  idempotencyHeader,
  lastEventHeader,
  logQuery,
  nameHeader,
  newerQuery,
  seqPath,
  waitQuery,
} from "../routes/reading.ts";
import { keyPath } from "../routes/keys.ts";
import { ifNoneMatchHeader } from "../routes/maze.ts";
import { scriptPath } from "../routes/scripts.ts";
import { pairingCalls } from "./pairing-calls.ts";
import { answer, entityTag, keyed, location, parameters, refusals } from "./parts.ts";

const robot = parameters("path", z.object({ id: robotIdSchema }));
const idempotencyKey = parameters("header", idempotencyHeader);
const driver = [{ driverKey: [] }];
const reader = [{ driverKey: [] }, { watchKey: [] }];
const logReader = [...reader, { ownerKey: [] }];
const line = [{ lineKey: [] }];
const owner = [{ ownerKey: [] }];
const shortLink = parameters("path", z.object({ id: shortLinkIdSchema }));
const scriptName = parameters("header", nameHeader);
/** The same for a call that scripts make. */
const asScript = [...keyed, "sent-away"] as const;

export const calls: ZodOpenApiPathsObject = {
  "/api/v1/robots": {
    post: {
      operationId: "registerRobot",
      summary: "Register a robot; its page does this",
      security: [],
      responses: {
        201: answer("The robot's id, keys and address.", registrationSchema, location),
        ...refusals("bad-request", "too-fast", "storage-full"),
      },
    },
  },
  "/api/v1/robots/{id}": {
    parameters: robot,
    get: {
      operationId: "showRobot",
      summary: "Show what is held of a robot",
      security: owner,
      responses: { 200: answer("What is held.", heldSessionSchema), ...refusals(...keyed) },
    },
    delete: {
      operationId: "deleteRobot",
      summary: "Delete a robot with all that is held of it",
      security: owner,
      responses: {
        204: { description: "All of it is deleted." },
        ...refusals(...keyed, "storage-full"),
      },
    },
  },
  "/api/v1/robots/{id}/keys": {
    parameters: robot,
    post: {
      operationId: "makeKey",
      summary: "Make a key for a script or for somebody who only watches",
      description:
        "With `replace` all earlier keys of the kind are revoked in the same step. The key is shown here " +
        "and never again.",
      security: owner,
      requestBody: { required: true, content: { "application/json": { schema: keyWishSchema } } },
      responses: {
        201: answer("The key, with the address for whoever uses it.", madeKeySchema, location),
        ...refusals(...keyed, "too-many-keys", "too-large", "not-json", "storage-full"),
      },
    },
    get: {
      operationId: "listKeys",
      summary: "List the keys of a robot by their ids",
      security: owner,
      responses: { 200: answer("All that count.", keyListSchema), ...refusals(...keyed) },
    },
  },
  "/api/v1/robots/{id}/keys/{keyId}": {
    parameters: [...robot, ...parameters("path", keyPath)],
    delete: {
      operationId: "revokeKey",
      summary: "Revoke a key",
      description:
        "It counts no more at once. Lines, event streams and requests that wait by it are closed, and " +
        "commands that were sent by it and have not ended are cancelled.",
      security: owner,
      responses: {
        204: { description: "It is revoked." },
        ...refusals(...keyed, "no-key", "storage-full"),
      },
    },
  },
  ...pairingCalls,
  "/api/v1/robots/{id}/scripts": {
    parameters: robot,
    get: {
      operationId: "listScripts",
      summary: "List the scripts of a robot by name, with what each did last",
      description:
        "Those that have a line or were heard in the last 2 minutes, and those that are away. A script is " +
        "told apart by its key and its name; one without a name, by its key and its language.",
      security: owner,
      responses: { 200: answer("The scripts.", scriptListSchema), ...refusals(...keyed) },
    },
  },
  "/api/v1/robots/{id}/pause": {
    parameters: robot,
    put: {
      operationId: "pauseDriving",
      summary: "Pause remote driving",
      description:
        "Commands of scripts are refused until they may drive again, all but a stop; what they asked for and " +
        "has not ended is cancelled. Scripts stay connected and read on. It is stored.",
      security: owner,
      responses: { 204: { description: "It is paused." }, ...refusals(...keyed) },
    },
    delete: {
      operationId: "resumeDriving",
      summary: "Let scripts drive again",
      security: owner,
      responses: { 204: { description: "They may drive." }, ...refusals(...keyed) },
    },
  },
  "/api/v1/robots/{id}/away": {
    parameters: robot,
    post: {
      operationId: "sendScriptAway",
      summary: "Send a script away, until it is let back",
      description:
        "Its lines are closed, its requests refused, and what it asked for and has not ended is cancelled. " +
        "Other scripts with the same key go on. It is no lock: to shut out whoever has the key, revoke it.",
      security: owner,
      requestBody: { required: true, content: { "application/json": { schema: scriptRefSchema } } },
      responses: {
        201: answer("The script that is away.", sentAwaySchema, location),
        ...refusals(...keyed, "no-key", "too-many-away", "too-large", "not-json"),
      },
    },
  },
  "/api/v1/robots/{id}/away/{scriptId}": {
    parameters: [...robot, ...parameters("path", scriptPath)],
    delete: {
      operationId: "letScriptBack",
      summary: "Let a script back that was sent away",
      security: owner,
      responses: { 204: { description: "It may come again." }, ...refusals(...keyed, "no-script") },
    },
  },
  "/api/v1/robots/{id}/sensors": {
    parameters: [...robot, ...scriptName],
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
      parameters: [...scriptName, ...parameters("header", ifNoneMatchHeader)],
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
    parameters: [...robot, ...scriptName],
    post: {
      operationId: "sendCommand",
      summary: "Send a command",
      description:
        "One that has not started within `ttl` ms (10 s where nothing is said) ends as `expired`. Send a " +
        "retry with the same key and with its `age`, the ms since the first try: then it never runs late.",
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
    parameters: [...robot, ...parameters("path", seqPath), ...scriptName],
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
    parameters: [...robot, ...scriptName],
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
            "text/event-stream": { schema: { type: "string" } },
          },
        },
        ...refusals(...asScript, "too-many-readers"),
      },
    },
  },
  "/api/v1/robots/{id}/line": {
    parameters: robot,
    post: {
      operationId: "openLine",
      summary: "Open a line for networks without WebSockets",
      description:
        "The messages are those of the WebSocket, which `/asyncapi.json` describes; `hello` is the body " +
        "of this call. A line on which no request waits is closed after 15 s without one.",
      security: [],
      requestBody: { required: true, content: { "application/json": { schema: helloSchema } } },
      responses: {
        201: answer("The key of the line.", openedLineSchema),
        ...refusals(...asScript, "too-large", "not-json", "too-many-readers"),
      },
    },
    delete: {
      operationId: "leaveLine",
      summary: "Close a line",
      security: line,
      responses: {
        204: { description: "It is closed." },
        ...refusals("bad-request", "not-authorised", "no-line"),
      },
    },
  },
  "/api/v1/robots/{id}/line/messages": {
    parameters: robot,
    post: {
      operationId: "sendMessages",
      summary: "Send messages on a line",
      description: "In the order of their numbers; what was sent before is taken once.",
      security: line,
      requestBody: {
        required: true,
        content: { "application/json": { schema: sentMessagesSchema } },
      },
      responses: {
        200: answer("How far they were taken.", takenMessagesSchema),
        ...refusals("bad-request", "not-authorised", "too-large", "not-json", "no-line"),
      },
    },
    get: {
      operationId: "fetchMessages",
      summary: "Fetch the messages of a line, or wait for one",
      description: "What came before `after` is forgotten; the rest is told again until it came.",
      security: line,
      parameters: parameters("query", fetchQuery),
      responses: {
        200: answer("What there is.", fetchedMessagesSchema),
        ...refusals("bad-request", "not-authorised", "no-line"),
      },
    },
  },
  "/api/v1/mazes": {
    post: {
      operationId: "storeDocument",
      summary: "Make a short link for a maze, program or challenge",
      description:
        "The same document gets the same link, and each time a key of its own that deletes it. It is " +
        "kept until nobody has used it for 180 days.",
      security: [],
      requestBody: { required: true, content: { "application/json": { schema: documentSchema } } },
      responses: {
        201: answer("The link and the key that deletes the document.", shortLinkSchema, location),
        ...refusals("bad-request", "too-large", "not-json", "too-fast", "storage-full"),
      },
    },
  },
  "/api/v1/mazes/{id}": {
    parameters: shortLink,
    get: {
      operationId: "readDocument",
      summary: "Read the document behind a short link",
      security: [],
      responses: {
        200: answer("The document.", documentSchema),
        ...refusals("bad-request", "no-document"),
      },
    },
    delete: {
      operationId: "deleteDocument",
      summary: "Delete the document behind a short link",
      description: "It is gone when all who stored the same document have deleted it.",
      security: [{ deleteKey: [] }],
      responses: {
        204: { description: "What was stored with this key is deleted." },
        ...refusals("bad-request", "not-authorised", "no-document", "storage-full"),
      },
    },
  },
  "/healthz": {
    get: {
      operationId: "checkHealth",
      summary: "Ask whether the service answers",
      security: [],
      responses: { 200: answer("It does.", healthSchema) },
    },
  },
  "/readyz": {
    get: {
      operationId: "checkReadiness",
      summary: "Ask whether the service should be sent work",
      security: [],
      responses: {
        200: answer("It should.", readySchema),
        ...refusals("restarting", "no-store"),
      },
    },
  },
};
