/**
 * `/docs` and `/problems`: how to write a script, the libraries, the protocol, a page for each kind of
 * problem, and a console to try the calls in. All of it comes from here, so that it works without any other network.
 */
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { Router } from "express";
import { framed } from "../docs/frame.ts";
import { pagesOfSite } from "../docs/site.ts";
import { methodNotAllowed } from "./fallbacks.ts";
import { ownFiles } from "./own-files.ts";
import { allowPolicy } from "./security-headers.ts";

const FOLDER = join(import.meta.dirname, "../docs");

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

export function docsRoutes(): Router {
  // Before the routes: a router that ends with another one lets every other request wait for a turn.
  const router = Router().use(ownFiles(FILES));
  for (const page of pagesOfSite()) {
    const html = framed(page);
    router
      .route(page.path)
      .get((_request, response) => {
        // Swagger UI cleans its markup with DOMPurify, which makes a policy of this name.
        allowPolicy(response, "dompurify");
        response.set("Cache-Control", "no-cache").type("html").send(html);
      })
      .all(methodNotAllowed("GET"));
  }
  return router;
}
