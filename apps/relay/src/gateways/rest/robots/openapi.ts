/** Operations to register, show and delete a robot. */
import {
  registrationSchema,
  snapshotSchema,
  driversSchema,
  mazeVersionSchema,
  robotIdSchema,
  gatewayNames,
} from "@corridor/protocol";
import { z } from "zod";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { answer, location, refusals } from "../../../platform/openapi/parts.ts";
import { keyed, owner, robot } from "../../requests/openapi-parts.ts";

/** Stored state of a robot, without its commands. */
export const heldSessionSchema = z.strictObject({
  id: robotIdSchema,
  createdAt: z.iso.datetime(),
  lastUsedAt: z.iso.datetime(),
  endsInSeconds: z
    .int()
    .min(0)
    .describe(
      "until the robot is deleted at the latest; it is deleted earlier after 2 h without use",
    ),
  drivers: driversSchema,
  maze: mazeVersionSchema
    .nullable()
    .describe("version of the maze that its page published; null if there is none"),
  /** null until the robot has reported */
  snapshot: snapshotSchema.nullable(),
  gateways: z
    .array(z.enum(gatewayNames))
    .describe("protocols by which this service connects programs to the robot, besides the API"),
});
export type HeldSession = z.infer<typeof heldSessionSchema>;

export const robotCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots": {
    post: {
      operationId: "registerRobot",
      summary: "Register a robot (used by its page)",
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
      operationId: "readRobot",
      summary: "Read the stored data of a robot",
      security: owner,
      responses: { 200: answer("The stored data.", heldSessionSchema), ...refusals(...keyed) },
    },
    delete: {
      operationId: "deleteRobot",
      summary: "Delete a robot with all of its data",
      security: owner,
      responses: {
        204: { description: "The robot is deleted." },
        ...refusals(...keyed, "storage-full"),
      },
    },
  },
};
