/** Registers, shows and deletes robots. */
import { Router } from "express";
import type { GatewayName } from "@corridor/protocol";
import type { RequestGuard } from "../../../platform/http/request-guard.ts";
import type { RobotRegistry } from "../../../robots/registry.ts";
import type { HeldSession } from "./openapi.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import { readBearer } from "../../../platform/http/reading.ts";

/** @param gateways those that the operator has not switched off */
export function robotRoutes(
  registry: RobotRegistry,
  guard: RequestGuard,
  gateways: readonly GatewayName[],
): Router {
  const router = Router();

  router
    .route("/robots")
    .post(async (request, response) => {
      const origin = guard.originOf(request);
      const registration = await registry.register(guard.addressOf(request), origin);
      response
        .status(201)
        .location(`/api/v1/robots/${registration.id}`)
        .set("Cache-Control", "no-store")
        .json(registration);
    })
    .all(methodNotAllowed("POST"));

  router
    .route("/robots/:id")
    .get(async (request, response) => {
      const { robot } = await registry.authorise(request.params.id, readBearer(request), "inspect");
      const stored: HeldSession = {
        id: robot.id,
        createdAt: new Date(robot.createdAt).toISOString(),
        lastUsedAt: new Date(robot.use.lastAt).toISOString(),
        endsInSeconds: Math.floor(robot.leftMs / 1000),
        drivers: robot.presence.now(),
        maze: (await robot.mazes.read())?.version ?? null,
        snapshot: robot.newest?.value ?? null,
        gateways: [...gateways],
      };
      response.json(stored);
    })
    .delete(async (request, response) => {
      const { robot } = await registry.authorise(request.params.id, readBearer(request), "remove");
      await registry.remove(robot);
      response.status(204).end();
    })
    .all(methodNotAllowed("GET, DELETE"));

  return router;
}
