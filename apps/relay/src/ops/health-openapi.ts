/** Operations for operators. */
import { z } from "zod";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { answer, refusals } from "../platform/openapi/parts.ts";

const healthSchema = z.strictObject({ status: z.literal("ok") });
export type Health = z.infer<typeof healthSchema>;

const readySchema = z.strictObject({
  status: z
    .enum(["ready", "degraded"])
    .describe("degraded: the disk is full, so the relay stores no new data"),
});
export type Ready = z.infer<typeof readySchema>;

export const healthSchemas = { Health: healthSchema, Ready: readySchema };

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
