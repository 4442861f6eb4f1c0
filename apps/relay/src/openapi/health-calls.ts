/** The HTTP calls of whoever watches over the service. */
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { healthSchema, readySchema } from "../routes/answers.ts";
import { answer, refusals } from "./parts.ts";

export const healthCalls: ZodOpenApiPathsObject = {
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
