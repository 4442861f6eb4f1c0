/** Operations on a robot's keys. */
import { keyListSchema, keyRequestSchema, createdKeySchema } from "@corridor/protocol";
import type { ZodOpenApiPathsObject } from "zod-openapi";
import { answer, location, parameters, refusals } from "../../../platform/openapi/parts.ts";
import { keyed, owner, robot } from "../../requests/openapi-parts.ts";
import { keyPath } from "./routes.ts";

export const keyCalls: ZodOpenApiPathsObject = {
  "/api/v1/robots/{id}/keys": {
    parameters: robot,
    post: {
      operationId: "createKey",
      summary: "Create a driver or watch key",
      description:
        "`replace` revokes earlier keys in the same transaction: true revokes all keys of this kind and use, an id " +
        "revokes one. The key is returned only once. A key with the `use` `url` stands in the path of a gateway's " +
        "URL, and is accepted nowhere else. `urls` are null for gateways that this service does not offer.",
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
};
