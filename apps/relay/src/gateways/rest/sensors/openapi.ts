/** The operation that reads the newest snapshot. */
import { snapshotSchema } from "@corridor/protocol";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { answer, parameters, refusals } from "../../../platform/openapi/parts.ts";
import { asScript, ofScript, reader, robot } from "../../requests/openapi-parts.ts";
import { newerQuery } from "../../requests/script-requests.ts";

export const sensorCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots/{id}/sensors": {
    parameters: [...robot, ...ofScript],
    get: {
      operationId: "readSensors",
      summary: "Read the newest snapshot, or wait for a newer one",
      description:
        "With `after` and `wait`, the relay responds as soon as it has a snapshot with a higher `seq`, or " +
        "with the newest snapshot after `wait` seconds.",
      security: reader,
      parameters: parameters("query", newerQuery),
      responses: {
        200: answer("The newest snapshot.", snapshotSchema),
        ...refusals(...asScript, "no-snapshot", "too-many-readers"),
      },
    },
  },
};
