/** The HTTP calls that take the place of a WebSocket. */
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
};
