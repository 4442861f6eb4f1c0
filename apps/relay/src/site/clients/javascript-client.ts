/**
 * `/corridor.js`: the main entry of the TypeScript package as one file. A script or a web page
 * imports it without an installation. `npm run build` makes it.
 */
import { existsSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { Router } from "express";
import { Refusal } from "../../platform/errors/problems.ts";
import { methodNotAllowed } from "../../platform/http/fallbacks.ts";
import { openToAllSites } from "../../platform/http/security-headers.ts";

const FILE = join(import.meta.dirname, "../../../dist/corridor.js");

export function javascriptClientRoutes(file: string = FILE): Router {
  const router = Router();
  router
    .route("/corridor.js")
    .all(openToAllSites)
    .get((_request, response) => {
      if (!existsSync(file)) {
        throw new Refusal(
          "not-found",
          "corridor.js has not been built yet. Run: npm run build (npm start does both).",
        );
      }
      response.set("Cache-Control", "no-cache").type("text/javascript; charset=utf-8");
      response.sendFile(basename(file), { root: dirname(file), cacheControl: false });
    })
    .all(methodNotAllowed("GET"));
  return router;
}
