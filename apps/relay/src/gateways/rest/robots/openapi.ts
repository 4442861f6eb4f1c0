/** Operations for a robot's owner: register and delete a robot, manage its keys and scripts. */
import {
  keyListSchema,
  keyRequestSchema,
  createdKeySchema,
  registrationSchema,
  scriptListSchema,
  scriptRefSchema,
  blockedScriptSchema,
} from "@corridor/protocol";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { heldSessionSchema } from "../../requests/answers.ts";
import { keyPath } from "../keys/routes.ts";
import { scriptPath } from "../scripts/routes.ts";
import {
  answer,
  keyed,
  location,
  owner,
  parameters,
  refusals,
  robot,
} from "../../../platform/openapi/parts.ts";

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
  "/api/v1/robots/{id}/keys": {
    parameters: robot,
    post: {
      operationId: "createKey",
      summary: "Create a driver or watch key",
      description:
        "`replace` revokes earlier keys in the same transaction: true revokes all keys of this kind, an id " +
        "revokes one. The key is returned only once.",
      security: owner,
      requestBody: {
        required: true,
        content: { "application/json": { schema: keyRequestSchema } },
      },
      responses: {
        201: answer("The key, with the address for its user.", createdKeySchema, location),
        ...refusals(
          ...keyed,
          "nothing-to-replace",
          "too-many-keys",
          "too-large",
          "not-json",
          "storage-full",
        ),
      },
    },
    get: {
      operationId: "listKeys",
      summary: "List the keys of a robot by their ids",
      security: owner,
      responses: { 200: answer("All valid keys.", keyListSchema), ...refusals(...keyed) },
    },
  },
  "/api/v1/robots/{id}/keys/{keyId}": {
    parameters: [...robot, ...parameters("path", keyPath)],
    delete: {
      operationId: "revokeKey",
      summary: "Revoke a key",
      description:
        "The key becomes invalid immediately. Its connections, event streams and waiting requests are closed, and its " +
        "open commands are cancelled.",
      security: owner,
      responses: {
        204: { description: "The key is revoked." },
        ...refusals(...keyed, "no-key", "storage-full"),
      },
    },
  },
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
        "Commands of scripts are rejected until driving is resumed, except for stops. Open commands of scripts are " +
        "cancelled. Scripts stay connected and can read. The state persists across restarts.",
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
