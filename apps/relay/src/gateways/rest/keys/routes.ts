/** Keys that a robot's owner creates for others and revokes. */
import {
  keyIdSchema,
  keyRequestSchema,
  type KeyList,
  type CreatedKey,
  type GatewayName,
} from "@corridor/protocol";
import { Router } from "express";
import { z } from "zod";
import type { RequestGuard } from "../../../platform/http/request-guard.ts";
import type { RobotRegistry } from "../../../robots/registry.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import { bodyReader, read, readBearer } from "../../../platform/http/reading.ts";

/** The id of a key, as the last segment of a path. */
export const keyPath = z.object({ keyId: keyIdSchema.describe("id of the key") });

const readKeyRequest = bodyReader(keyRequestSchema, "Invalid key request.");

/** @param gateways those that the operator has not switched off */
export function keyRoutes(
  registry: RobotRegistry,
  guard: RequestGuard,
  gateways: readonly GatewayName[],
): Router {
  const router = Router();
  const hasMcp = gateways.includes("mcp");
  const hasRos = gateways.includes("ros");

  router
    .route("/robots/:id/keys")
    .post(async (request, response) => {
      const { robot } = await registry.authorise(request.params.id, readBearer(request), "grant");
      const wanted = await readKeyRequest(request, response);
      const made = await robot.keys.make(wanted);
      const page = `${guard.originOf(request)}/r/${robot.id}`;
      const created: CreatedKey =
        wanted.use === "url"
          ? {
              ...made,
              address: null,
              urls: {
                ros: hasRos ? `${page.replace(/^http/, "ws")}/ros/${made.key}` : null,
                mcp: hasMcp ? `${page}/mcp/${made.key}` : null,
              },
            }
          : { ...made, address: `${page}#${made.key}`, urls: null };
      response
        .status(201)
        .location(`/api/v1/robots/${robot.id}/keys/${made.id}`)
        .set("Cache-Control", "no-store")
        .json(created);
    })
    .get(async (request, response) => {
      const { robot } = await registry.authorise(request.params.id, readBearer(request), "grant");
      const list: KeyList = { keys: await robot.keys.list() };
      response.json(list);
    })
    .all(methodNotAllowed("POST, GET"));

  router
    .route("/robots/:id/keys/:keyId")
    .delete(async (request, response) => {
      const { robot } = await registry.authorise(request.params.id, readBearer(request), "grant");
      const { keyId } = read(keyPath, { keyId: request.params.keyId }, "Invalid path.");
      await robot.keys.revoke(keyId);
      response.status(204).end();
    })
    .all(methodNotAllowed("DELETE"));

  return router;
}
