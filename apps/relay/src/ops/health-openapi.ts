/** Operations for operators. */
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { healthSchema, readySchema } from "../gateways/requests/answers.ts";
import { answer, refusals } from "../platform/openapi/parts.ts";

export const healthCalls: ZodOpenApiPathsObject = {
  "/healthz": {
    get: {
      operationId: "checkHealth",
      summary: "Check whether the service responds",
      security: [],
      responses: { 200: answer("The service responds.", healthSchema) },
    },
  },
  "/readyz": {
    get: {
      operationId: "checkReadiness",
      summary: "Check whether the service is ready for requests",
      security: [],
      responses: {
        200: answer("The service is ready.", readySchema),
        ...refusals("restarting", "no-store"),
      },
    },
  },
};
