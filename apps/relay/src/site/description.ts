/**
 * Serves the machine-readable API descriptions `/openapi.json` and `/asyncapi.json`, which are
 * loaded and built at their first request.
 */
import { Router } from "express";
import { methodNotAllowed } from "../platform/http/fallbacks.ts";
import { openToAllSites } from "../platform/http/security-headers.ts";

const builders = {
  "/openapi.json": async () => (await import("./openapi/document.ts")).describeApi(),
  "/asyncapi.json": async () => (await import("./asyncapi/document.ts")).describeMessages(),
};

export function descriptionRoutes(): Router {
  const router = Router();
  for (const [path, describe] of Object.entries(builders)) {
    let text: string | null = null;
    router
      .route(path)
      .all(openToAllSites)
      .get(async (_request, response) => {
        text ??= JSON.stringify(await describe());
        response.set("Cache-Control", "public, max-age=300").type("json").send(text);
      })
      .all(methodNotAllowed("GET"));
  }
  return router;
}
