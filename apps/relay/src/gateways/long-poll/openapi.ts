/** Operations of long-poll connections, the alternative to a WebSocket. */
import {
  fetchedMessagesSchema,
  helloSchema,
  openedConnectionSchema,
  sentMessagesSchema,
  takenMessagesSchema,
} from "@corridor/protocol";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { fetchQuery } from "../requests/reading.ts";
import { answer, parameters, refusals } from "../../platform/openapi/parts.ts";
import { asScript, robot } from "../requests/openapi-parts.ts";

const connection = [{ connectionKey: [] }];

export const longPollCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots/{id}/long-poll": {
    parameters: robot,
    post: {
      operationId: "openConnection",
      summary: "Open a long-poll connection, for networks without WebSockets",
      description:
        "The messages are those of the WebSocket: see `/asyncapi.json`. The body of this request is " +
        "`hello`. A connection closes 15 s after its last request has ended.",
      security: [],
      requestBody: { required: true, content: { "application/json": { schema: helloSchema } } },
      responses: {
        201: answer("The key of the connection.", openedConnectionSchema),
        ...refusals(...asScript, "too-large", "not-json", "too-many-readers"),
      },
    },
    delete: {
      operationId: "closeConnection",
      summary: "Close a long-poll connection",
      security: connection,
      responses: {
        204: { description: "The connection is closed." },
        ...refusals("bad-request", "not-authorised", "no-connection"),
      },
    },
  },
  "/api/v1/robots/{id}/long-poll/messages": {
    parameters: robot,
    post: {
      operationId: "sendMessages",
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
      operationId: "fetchMessages",
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
