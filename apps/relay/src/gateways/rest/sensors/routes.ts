/** The newest snapshot of a robot, immediately or by waiting for a newer one. */
import { Router } from "express";
import type { RobotRegistry } from "../../../robots/registry.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import { authoriseScript, readNewer, readSnapshot } from "../../requests/script-requests.ts";

export function sensorRoutes(registry: RobotRegistry): Router {
  const router = Router();
  router
    .route("/robots/:id/sensors")
    .get(async (request, response) => {
      const script = await authoriseScript(registry, request, response, "read");
      response.json(await readSnapshot(script, readNewer(request), response));
    })
    .all(methodNotAllowed("GET"));
  return router;
}
