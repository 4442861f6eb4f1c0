/** Operations of long-poll connections, the alternative to a WebSocket. */
import {
  fetchedMessagesSchema,
  classHelloSchema,
  helloSchema,
  openedConnectionSchema,
  sentMessagesSchema,
  takenMessagesSchema,
} from "@corridor/protocol";
import type { z } from "zod";
import type { oas31, ZodOpenApiPathsObject } from "zod-openapi";
import type { ProblemKind } from "../../platform/errors/problem-kinds.ts";
import { classPath } from "../rest/classes/reading.ts";
import { fetchQuery } from "../requests/script-requests.ts";
import { answer, parameters, refusals } from "../../platform/openapi/parts.ts";
import { asScript, robot } from "../requests/openapi-parts.ts";

const connection = [{ connectionKey: [] }];

interface Described {
  name: "robots" | "classes";
  path: oas31.ParameterObject[];
  hello: z.ZodType;
  /** errors of the hello */
  opening: readonly ProblemKind[];
  noun: string;
  /** of the ids of the operations */
  suffix: string;
}

function callsOf({ name, path, hello, opening, noun, suffix }: Described): ZodOpenApiPathsObject {
  return {
    [`/api/v1/${name}/{id}/long-poll`]: {
      parameters: path,
      post: {
        operationId: `open${suffix}`,
        summary: `Open a long-poll connection to a ${noun}, for networks without WebSockets`,
        description:
          "The messages are those of the WebSocket: see `/asyncapi.json`. The body of this request is " +
          "`hello`. A connection closes 15 s after its last request has ended.",
        security: [],
        requestBody: { required: true, content: { "application/json": { schema: hello } } },
        responses: {
          201: answer("The key of the connection.", openedConnectionSchema),
          ...refusals(...opening, "too-large", "not-json", "too-many-readers"),
        },
      },
      delete: {
        operationId: `close${suffix}`,
        summary: "Close a long-poll connection",
        security: connection,
        responses: {
          204: { description: "The connection is closed." },
          ...refusals("bad-request", "not-authorised", "no-connection"),
        },
      },
    },
    [`/api/v1/${name}/{id}/long-poll/messages`]: {
      parameters: path,
      post: {
        operationId: `send${suffix.replace("Connection", "Messages")}`,
        summary: "Send messages on a long-poll connection",
        description:
          "The relay processes messages in the order of their numbers. It processes repeated messages once.",
        security: connection,
        requestBody: {
          required: true,
          content: { "application/json": { schema: sentMessagesSchema } },
        },
        responses: {
          200: answer("The number of the last message that was processed.", takenMessagesSchema),
          ...refusals("bad-request", "not-authorised", "too-large", "not-json", "no-connection"),
        },
      },
      get: {
        operationId: `fetch${suffix.replace("Connection", "Messages")}`,
        summary: "Fetch the messages of a long-poll connection, or wait for one",
        description:
          "`after` acknowledges all messages up to this number. The relay returns the others until they are acknowledged.",
        security: connection,
        parameters: parameters("query", fetchQuery),
        responses: {
          200: answer("The pending messages.", fetchedMessagesSchema),
          ...refusals("bad-request", "not-authorised", "no-connection"),
        },
      },
    },
  };
}

export const longPollCalls: ZodOpenApiPathsObject = {
  ...callsOf({
    name: "robots",
    path: robot,
    hello: helloSchema,
    opening: asScript,
    noun: "robot",
    suffix: "Connection",
  }),
  ...callsOf({
    name: "classes",
    path: parameters("path", classPath),
    hello: classHelloSchema,
    opening: ["bad-request", "not-authorised", "forbidden", "no-class"],
    noun: "class",
    suffix: "ClassConnection",
  }),
};
