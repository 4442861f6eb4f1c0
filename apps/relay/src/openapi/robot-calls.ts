/** The HTTP calls of a robot's owner: register it, give keys, see and send away scripts, delete it. */
import {
  keyListSchema,
  keyWishSchema,
  madeKeySchema,
  registrationSchema,
  scriptListSchema,
  scriptRefSchema,
  sentAwaySchema,
} from "@corridor/protocol";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { heldSessionSchema } from "../routes/answers.ts";
import { keyPath } from "../routes/keys.ts";
import { scriptPath } from "../routes/scripts.ts";
import { answer, keyed, location, owner, parameters, refusals, robot } from "./parts.ts";

export const robotCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots": {
    post: {
      operationId: "registerRobot",
      summary: "Register a robot; its page does this",
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
      operationId: "showRobot",
      summary: "Show what is held of a robot",
      security: owner,
      responses: { 200: answer("What is held.", heldSessionSchema), ...refusals(...keyed) },
    },
    delete: {
      operationId: "deleteRobot",
      summary: "Delete a robot with all that is held of it",
      security: owner,
      responses: {
        204: { description: "All of it is deleted." },
        ...refusals(...keyed, "storage-full"),
      },
    },
  },
  "/api/v1/robots/{id}/keys": {
    parameters: robot,
    post: {
      operationId: "makeKey",
      summary: "Make a key for a script or for somebody who only watches",
      description:
        "With `replace` earlier keys are revoked in the same step: all of the kind by true, the one of the " +
        "kind with this id by an id. The key is shown here and never again.",
      security: owner,
      requestBody: { required: true, content: { "application/json": { schema: keyWishSchema } } },
      responses: {
        201: answer("The key, with the address for whoever uses it.", madeKeySchema, location),
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
      responses: { 200: answer("All that count.", keyListSchema), ...refusals(...keyed) },
    },
  },
  "/api/v1/robots/{id}/keys/{keyId}": {
    parameters: [...robot, ...parameters("path", keyPath)],
    delete: {
      operationId: "revokeKey",
      summary: "Revoke a key",
      description:
        "It counts no more at once. Lines, event streams and requests that wait by it are closed, and " +
        "commands that were sent by it and have not ended are cancelled.",
      security: owner,
      responses: {
        204: { description: "It is revoked." },
        ...refusals(...keyed, "no-key", "storage-full"),
      },
    },
  },
  "/api/v1/robots/{id}/scripts": {
    parameters: robot,
    get: {
      operationId: "listScripts",
      summary: "List the scripts of a robot by name, with what each did last",
      description:
        "Those that have a line or were heard in the last 2 minutes, and those that are away. A script is " +
        "told apart by its key and its name; one without a name, by its key and its language.",
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
        "Commands of scripts are refused until they may drive again, all but a stop; what they asked for and " +
        "has not ended is cancelled. Scripts stay connected and read on. It is stored.",
      security: owner,
      responses: { 204: { description: "It is paused." }, ...refusals(...keyed) },
    },
    delete: {
      operationId: "resumeDriving",
      summary: "Let scripts drive again",
      security: owner,
      responses: { 204: { description: "They may drive." }, ...refusals(...keyed) },
    },
  },
  "/api/v1/robots/{id}/away": {
    parameters: robot,
    post: {
      operationId: "sendScriptAway",
      summary: "Block a script, until it is unblocked",
      description:
        "Its lines are closed, its requests refused, and what it asked for and has not ended is cancelled. " +
        "Other scripts with the same key go on. It is no lock: to shut out whoever has the key, revoke it.",
      security: owner,
      requestBody: { required: true, content: { "application/json": { schema: scriptRefSchema } } },
      responses: {
        201: answer("The script that is away.", sentAwaySchema, location),
        ...refusals(...keyed, "unknown-driver", "too-many-away", "too-large", "not-json"),
      },
    },
  },
  "/api/v1/robots/{id}/away/{scriptId}": {
    parameters: [...robot, ...parameters("path", scriptPath)],
    delete: {
      operationId: "letScriptBack",
      summary: "Unblock a script",
      security: owner,
      responses: { 204: { description: "It may come again." }, ...refusals(...keyed, "no-script") },
    },
  },
};
