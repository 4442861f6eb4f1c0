/** The maze of a robot: its page publishes it, and scripts and watchers read it. */
import { mazeSchema } from "@corridor/maze";
import { MAX_DOCUMENT_BYTES } from "@corridor/protocol";
import { Router } from "express";
import { noMaze } from "../../../robots/maze-board.ts";
import type { RobotRegistry } from "../../../robots/registry.ts";
import { entityTag, matchesTag } from "../../../platform/http/entity-tags.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import { authoriseScript } from "../../requests/script-requests.ts";
import { bodyReader, readBearer } from "../../../platform/http/reading.ts";

const readMaze = bodyReader(mazeSchema, "Invalid maze.", { limit: MAX_DOCUMENT_BYTES });

export function mazeRoutes(registry: RobotRegistry): Router {
  const router = Router();
  router
    .route("/robots/:id/maze")
    .get(async (request, response) => {
      const { robot } = await authoriseScript(registry, request, response, "look");
      const stored = await robot.mazes.read();
      if (stored === null) throw noMaze();
      const tag = entityTag(stored.version);
      response.set("ETag", tag);
      if (matchesTag(request.get("If-None-Match"), tag)) return void response.status(304).end();
      response.type("json").send(stored.text);
    })
    .put(async (request, response) => {
      const { robot } = await registry.authorise(request.params.id, readBearer(request), "host");
      const version = await robot.mazes.keep(await readMaze(request, response));
      response.status(204).set("ETag", entityTag(version)).end();
    })
    .all(methodNotAllowed("GET, PUT"));
  return router;
}
