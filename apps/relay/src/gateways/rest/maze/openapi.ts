/** Operations on a robot's maze. */
import { mazeSchema } from "@corridor/maze";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { ifNoneMatchHeader } from "../../../platform/http/entity-tags.ts";
import { answer, entityTag, parameters, refusals } from "../../../platform/openapi/parts.ts";
import { anyKey, asScript, keyed, ofScript, owner, robot } from "../../requests/openapi-parts.ts";

export const mazeCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots/{id}/maze": {
    parameters: robot,
    get: {
      operationId: "readMaze",
      summary: "Read the maze of the robot",
      description:
        "The response is the maze that the robot's page published. When it changes, readers receive a `maze` message or " +
        "event with the new `ETag` as `version`.",
      security: anyKey,
      parameters: [...ofScript, ...parameters("header", ifNoneMatchHeader)],
      responses: {
        200: answer("The maze.", mazeSchema, entityTag),
        304: { description: "The cached maze is current.", headers: entityTag },
        ...refusals(...asScript, "no-maze"),
      },
    },
    put: {
      operationId: "publishMaze",
      summary: "Publish the maze of the robot (used by its page)",
      description:
        "The maze replaces the previous one, and is deleted with the robot. An equal maze " +
        "changes nothing. A robot can publish one maze a second, with bursts of 20.",
      security: owner,
      requestBody: { required: true, content: { "application/json": { schema: mazeSchema } } },
      responses: {
        204: { description: "The maze is stored.", headers: entityTag },
        ...refusals(...keyed, "too-large", "not-json", "too-fast", "storage-full"),
      },
    },
  },
};
