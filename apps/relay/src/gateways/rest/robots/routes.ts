/** Registers, shows and deletes robots. */
import { Router } from "express";
import type { RequestGuard } from "../../../platform/http/request-guard.ts";
import type { SessionHub } from "../../../robots/registry.ts";
import type { HeldSession } from "./openapi.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import { readBearer } from "../../../platform/http/reading.ts";

export function robotRoutes(hub: SessionHub, guard: RequestGuard): Router {
  const router = Router();

  router
    .route("/robots")
    .post(async (request, response) => {
      const origin = guard.originOf(request);
      const registration = await hub.register(guard.addressOf(request), origin);
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
      const { session } = await hub.authorise(request.params.id, readBearer(request), "inspect");
      const stored: HeldSession = {
        id: session.id,
        createdAt: new Date(session.createdAt).toISOString(),
        lastUsedAt: new Date(session.lastUsedAt).toISOString(),
        endsInSeconds: Math.floor(session.leftMs / 1000),
        drivers: session.roster.now(),
        maze: (await session.mazes.read())?.version ?? null,
        snapshot: session.newest?.value ?? null,
      };
      response.json(stored);
    })
    .delete(async (request, response) => {
      const { session } = await hub.authorise(request.params.id, readBearer(request), "remove");
      await hub.remove(session);
      response.status(204).end();
    })
    .all(methodNotAllowed("GET, DELETE"));

  return router;
}
