/** The newest snapshot of a robot, at once or as soon as there is a newer one. */
import { Router } from "express";
import { Refusal } from "../problems.ts";
import type { SessionHub } from "../sessions/session-hub.ts";
import { methodNotAllowed } from "./fallbacks.ts";
import { hearScript } from "./hear-script.ts";
import { patienceOf, readNewer } from "./reading.ts";

export function sensorRoutes(hub: SessionHub): Router {
  const router = Router();
  router
    .route("/robots/:id/sensors")
    .get(async (request, response) => {
      const { session, key } = await hearScript(hub, request, response, "read");
      const { after = -1, wait } = readNewer(request);
      const snapshot = await session.readers.nextSnapshot(after, patienceOf(response, wait, key));
      if (snapshot === null) {
        throw new Refusal(
          "no-snapshot",
          "The robot's page has not reported yet. Open the page and connect it under Remote; with ?wait=25 this call waits for it.",
        );
      }
      response.json(snapshot);
    })
    .all(methodNotAllowed("GET"));
  return router;
}
