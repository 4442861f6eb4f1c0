/** The operation that follows events, as a stream or by long polling. */
import { eventPageSchema } from "@corridor/protocol";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { parameters, refusals } from "../../platform/openapi/parts.ts";
import { asScript, ofScript, reader, robot } from "../requests/openapi-parts.ts";
import { eventsQuery, lastEventHeader } from "../requests/script-requests.ts";
import { streamedEventSchema } from "./streamed-event.ts";

export const eventCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots/{id}/events": {
    parameters: [...robot, ...ofScript],
    get: {
      operationId: "followEvents",
      summary: "Follow a robot by server-sent events, or by long polling",
      description:
        "Without `wait`: an endless stream of events. Send the `id` of the last event as `Last-Event-ID` or `since` " +
        "to resume there.\n\n" +
        "- `snapshot` contains a Snapshot.\n" +
        "- `state` contains the CommandRecord of a command with a new state.\n" +
        "- `gap` replaces states that are no longer stored.\n" +
        "- `maze` contains the version of another maze.\n\n" +
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
