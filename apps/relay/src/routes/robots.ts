/** Registering a robot, showing what is stored of it, deleting it. */
import { Router, type Request } from "express";
import { Refusal } from "../problems.ts";
import type { SessionHub } from "../sessions/session-hub.ts";
import type { HeldSession } from "./answers.ts";
import { methodNotAllowed } from "./fallbacks.ts";
import { readBearer } from "./reading.ts";

/** @param publicOrigin origin of the service as seen from outside; null: what the request says */
export function robotRoutes(hub: SessionHub, publicOrigin: string | null): Router {
  const router = Router();

  router
    .route("/robots")
    .post(async (request, response) => {
      const origin = publicOrigin ?? originOf(request);
      const registration = await hub.register(request.socket.remoteAddress ?? "", origin);
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
      const { session } = await hub.authorise(request.params.id, readBearer(request), ["own"]);
      const held: HeldSession = {
        id: session.id,
        createdAt: new Date(session.createdAt).toISOString(),
        lastUsedAt: new Date(session.lastUsedAt).toISOString(),
        drivers: session.roster.now(),
        snapshot: session.newest,
      };
      response.json(held);
    })
    .delete(async (request, response) => {
      const { session } = await hub.authorise(request.params.id, readBearer(request), ["own"]);
      await hub.remove(session);
      response.status(204).end();
    })
    .all(methodNotAllowed("GET, DELETE"));

  return router;
}

/** The origin that the page itself was opened with. */
function originOf(request: Request): string {
  const host = request.get("host") ?? "";
  const url = `${request.protocol}://${host}`;
  if (!URL.canParse(url) || new URL(url).host !== host.toLowerCase()) {
    throw new Refusal("bad-request", "The header Host must name the address of this service.");
  }
  return new URL(url).origin;
}
