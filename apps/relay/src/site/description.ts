/** Serves the machine-readable API descriptions `/openapi.json` and `/asyncapi.json`. */
import { Router } from "express";
import { describeMessages } from "./asyncapi/document.ts";
import { describeApi } from "./openapi/document.ts";
import { methodNotAllowed } from "../platform/http/fallbacks.ts";
import { openToAllSites } from "../platform/http/security-headers.ts";

// Built once, while the relay starts. Relays in one process, as in tests, share them.
const descriptions = {
  "/openapi.json": JSON.stringify(describeApi()),
  "/asyncapi.json": JSON.stringify(describeMessages()),
};

export function descriptionRoutes(): Router {
  const router = Router();
  for (const [path, text] of Object.entries(descriptions)) {
    router
      .route(path)
      .all(openToAllSites)
      .get((_request, response) => {
        response.set("Cache-Control", "public, max-age=300").type("json").send(text);
      })
      .all(methodNotAllowed("GET"));
  }
  return router;
}
