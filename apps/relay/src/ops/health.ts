/** Liveness (`/healthz`) and readiness (`/readyz`) of the relay. */
import { Router, type RequestHandler } from "express";
import { Refusal, restarting, retryAfter } from "../platform/errors/problems.ts";
import type { Readiness } from "./readiness.ts";
import type { Health, Ready } from "./health-openapi.ts";
import { methodNotAllowed } from "../platform/http/fallbacks.ts";

const noStore: RequestHandler = (_request, response, next) => {
  response.set("Cache-Control", "no-store");
  next();
};

export function healthRoutes(readiness: Readiness): Router {
  const router = Router();
  router
    .route("/healthz")
    .get(noStore, (_request, response) => {
      const health: Health = { status: "ok" };
      response.json(health);
    })
    .all(methodNotAllowed("GET"));
  router
    .route("/readyz")
    .get(noStore, async (_request, response) => {
      const status = await readiness.status();
      if (status === "draining") throw restarting();
      if (status === "unavailable") {
        throw new Refusal(
          "no-store",
          "The relay's store is unavailable. The relay's log contains the reason.",
          {
            headers: retryAfter(5_000),
          },
        );
      }
      const ready: Ready = { status };
      response.json(ready);
    })
    .all(methodNotAllowed("GET"));
  return router;
}
