/**
 * `/docs` and `/problems`: guides, libraries, host promises, one page for each kind of problem, and an
 * API console. All files are served from here, so that the pages work without internet access.
 */
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { Router } from "express";
import { renderPage } from "./frame.ts";
import { pagesOfSite } from "./site.ts";
import type { GatewayName } from "@corridor/protocol";
import { methodNotAllowed } from "../../platform/http/fallbacks.ts";
import { listedFiles } from "../../platform/http/listed-files.ts";
import { allowPolicy } from "../../platform/http/security-headers.ts";

const FOLDER = import.meta.dirname;

const FILES = {
  "/docs/docs.css": join(FOLDER, "docs.css"),
  "/docs/copy.js": join(FOLDER, "copy.js"),
  "/docs/tabs.js": join(FOLDER, "tabs.js"),
  "/docs/docs.js": join(FOLDER, "docs.js"),
  "/docs/swagger-ui.css": fileURLToPath(import.meta.resolve("swagger-ui-dist/swagger-ui.css")),
  "/docs/swagger-ui-bundle.js": fileURLToPath(
    import.meta.resolve("swagger-ui-dist/swagger-ui-bundle.js"),
  ),
};

/** @param gateways those that the operator has not switched off */
export function docsRoutes(gateways: readonly GatewayName[]): Router {
  // Before the routes, because a nested router at the end delays every other request by a turn.
  const router = Router().use(listedFiles(FILES));
  for (const page of pagesOfSite(gateways)) {
    // Rendering all pages would take a fifth of the relay's start.
    let html: string | null = null;
    router
      .route(page.path)
      .get((_request, response) => {
        // Swagger UI sanitises its markup with DOMPurify, which creates a trusted-types policy of
        // this name.
        allowPolicy(response, "dompurify");
        response
          .set("Cache-Control", "no-cache")
          .type("html")
          .send((html ??= renderPage(page)));
      })
      .all(methodNotAllowed("GET"));
  }
  return router;
}
