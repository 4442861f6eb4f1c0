/** Whether the relay lives (`/healthz`) and whether it should be sent work (`/readyz`). */
import { Router, type RequestHandler } from "express";
import { Refusal, restarting, retryAfter } from "../problems.ts";
import type { Readiness } from "../readiness.ts";
import type { Health, Ready } from "./answers.ts";
import { methodNotAllowed } from "./fallbacks.ts";

const neverKept: RequestHandler = (_request, response, next) => {
  response.set("Cache-Control", "no-store");
  next();
};

export function healthRoutes(readiness: Readiness): Router {
  const router = Router();
  router
    .route("/healthz")
    .get(neverKept, (_request, response) => {
      const health: Health = { status: "ok" };
      response.json(health);
    })
    .all(methodNotAllowed("GET"));
  router
    .route("/readyz")
    .get(neverKept, async (_request, response) => {
      const status = await readiness.status();
      if (status === "draining") throw restarting();
      if (status === "unavailable") {
        throw new Refusal("no-store", "Whoever runs this relay finds the reason in its log.", {
          headers: retryAfter(5_000),
        });
      }
      const ready: Ready = { status };
      response.json(ready);
    })
    .all(methodNotAllowed("GET"));
  return router;
}
