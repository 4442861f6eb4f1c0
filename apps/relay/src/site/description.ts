/**
 * Serves the machine-readable API descriptions `/openapi.json` and `/asyncapi.json`, which are
 * built once at startup.
 */
import { Router } from "express";
import { describeMessages } from "./asyncapi/document.ts";
import { describeApi } from "./openapi/document.ts";
import { methodNotAllowed } from "../platform/http/fallbacks.ts";
import { openToAllSites } from "../platform/http/security-headers.ts";

export function descriptionRoutes(): Router {
  const router = Router();
  const descriptions = { "/openapi.json": describeApi(), "/asyncapi.json": describeMessages() };
  for (const [path, description] of Object.entries(descriptions)) {
    const text = JSON.stringify(description);
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
