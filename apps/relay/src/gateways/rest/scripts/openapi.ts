/** Operations on a robot's scripts: list, block and pause, and whether they may reset it. */
import { scriptListSchema, scriptRefSchema, blockedScriptSchema } from "@corridor/protocol";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { answer, location, parameters, refusals } from "../../../platform/openapi/parts.ts";
import { keyed, owner, robot } from "../../requests/openapi-parts.ts";
import { scriptPath } from "./routes.ts";

export const scriptCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots/{id}/scripts": {
    parameters: robot,
    get: {
      operationId: "listScripts",
      summary: "List the scripts of a robot by name, with the last command of each",
      description:
        "Lists the scripts that are connected, were active in the last 2 minutes, or are blocked. A script is " +
        "identified by its key and its name, or without a name by its key and its language.",
      security: owner,
      responses: { 200: answer("The scripts.", scriptListSchema), ...refusals(...keyed) },
    },
  },
  "/api/v1/robots/{id}/pause": {
    parameters: robot,
    put: {
      operationId: "pauseDriving",
      summary: "Pause remote driving",
      description:
        "The relay cancels the open commands of scripts, and rejects new ones except stops until driving is resumed. " +
        "Scripts stay connected and can read. The pause persists across restarts.",
      security: owner,
      responses: { 204: { description: "Driving is paused." }, ...refusals(...keyed) },
    },
    delete: {
      operationId: "resumeDriving",
      summary: "Resume remote driving",
      security: owner,
      responses: { 204: { description: "Scripts can drive." }, ...refusals(...keyed) },
    },
  },
  "/api/v1/robots/{id}/script-reset": {
    parameters: robot,
    put: {
      operationId: "permitReset",
      summary: "Let scripts reset the robot, which is the default",
      security: owner,
      responses: { 204: { description: "Scripts may send `reset`." }, ...refusals(...keyed) },
    },
    delete: {
      operationId: "forbidReset",
      summary: "Do not let scripts reset the robot",
      description: "The relay rejects `reset` with `reset-disabled`. It persists across restarts.",
      security: owner,
      responses: { 204: { description: "Resets are rejected." }, ...refusals(...keyed) },
    },
  },
  "/api/v1/robots/{id}/blocked": {
    parameters: robot,
    post: {
      operationId: "blockScript",
      summary: "Block a script",
      description:
        "The relay closes the script's connections, rejects its requests and cancels its open commands. " +
        "Other scripts with the same key are not affected. Blocking is not access control: a script can use another name. To exclude all scripts with a key, revoke the key.",
      security: owner,
      requestBody: { required: true, content: { "application/json": { schema: scriptRefSchema } } },
      responses: {
        201: answer("The blocked script.", blockedScriptSchema, location),
        ...refusals(...keyed, "unknown-driver", "too-many-blocked", "too-large", "not-json"),
      },
    },
  },
  "/api/v1/robots/{id}/blocked/{scriptId}": {
    parameters: [...robot, ...parameters("path", scriptPath)],
    delete: {
      operationId: "unblockScript",
      summary: "Unblock a script",
      security: owner,
      responses: {
        204: { description: "The script can connect again." },
        ...refusals(...keyed, "no-script"),
      },
    },
  },
};
