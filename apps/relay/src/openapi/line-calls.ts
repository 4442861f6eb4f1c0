/** Operations of long-poll connections, the alternative to a WebSocket. */
import {
  fetchedMessagesSchema,
  helloSchema,
  openedLineSchema,
  sentMessagesSchema,
  takenMessagesSchema,
} from "@corridor/protocol";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { fetchQuery } from "../routes/reading.ts";
import { answer, asScript, parameters, refusals, robot } from "./parts.ts";

const line = [{ lineKey: [] }];

export const lineCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots/{id}/line": {
    parameters: robot,
    post: {
      operationId: "openLine",
      summary: "Open a long-poll connection, for networks without WebSockets",
      description:
        "The messages are those of the WebSocket, which `/asyncapi.json` describes. The body of this request is " +
        "`hello`. A connection closes 15 s after its last request has ended.",
      security: [],
      requestBody: { required: true, content: { "application/json": { schema: helloSchema } } },
      responses: {
        201: answer("The key of the connection.", openedLineSchema),
        ...refusals(...asScript, "too-large", "not-json", "too-many-readers"),
      },
    },
    delete: {
      operationId: "leaveLine",
      summary: "Close a long-poll connection",
      security: line,
      responses: {
        204: { description: "The connection is closed." },
        ...refusals("bad-request", "not-authorised", "no-line"),
      },
    },
  },
  "/api/v1/robots/{id}/line/messages": {
    parameters: robot,
    post: {
      operationId: "sendMessages",
      summary: "Send messages on a long-poll connection",
      description:
        "Messages are processed in the order of their numbers, and repeated messages once.",
      security: line,
      requestBody: {
        required: true,
        content: { "application/json": { schema: sentMessagesSchema } },
      },
      responses: {
        200: answer("The number of the last message that was processed.", takenMessagesSchema),
        ...refusals("bad-request", "not-authorised", "too-large", "not-json", "no-line"),
      },
    },
    get: {
      operationId: "fetchMessages",
      summary: "Fetch the messages of a long-poll connection, or wait for one",
      description:
        "Messages up to `after` are acknowledged and deleted. The others are returned again until then.",
      security: line,
      parameters: parameters("query", fetchQuery),
      responses: {
        200: answer("The pending messages.", fetchedMessagesSchema),
        ...refusals("bad-request", "not-authorised", "no-line"),
      },
    },
  },
};
