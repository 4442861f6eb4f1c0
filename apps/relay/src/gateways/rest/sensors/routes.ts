/** The newest snapshot of a robot, immediately or by waiting for a newer one. */
import { Router } from "express";
import { Refusal } from "../../../platform/errors/problems.ts";
import type { RobotRegistry } from "../../../robots/registry.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import { authoriseScript, callerWaitOf, readNewer } from "../../requests/script-requests.ts";

export function sensorRoutes(registry: RobotRegistry): Router {
  const router = Router();
  router
    .route("/robots/:id/sensors")
    .get(async (request, response) => {
      const { robot, caller } = await authoriseScript(registry, request, response, "read");
      const { after = -1, wait } = readNewer(request);
      const snapshot = await robot.readers.nextSnapshot(
        after,
        callerWaitOf(response, wait, caller),
      );
      if (snapshot === null) {
        throw new Refusal(
          "no-snapshot",
          "The robot's page has not reported yet. Open the page and connect it under Remote. With ?wait=25 this request waits for the report.",
        );
      }
      response.json(snapshot);
    })
    .all(methodNotAllowed("GET"));
  return router;
}
