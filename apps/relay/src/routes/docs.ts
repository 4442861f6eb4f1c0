/**
 * `/docs`: how to write a script, the whole protocol, and a console to try the calls in. All of it comes
 * from here, so that it works without any other network.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { Router } from "express";
import { htmlOf } from "../docs/markdown.ts";
import { methodNotAllowed } from "./fallbacks.ts";
import { ownFiles } from "./own-files.ts";
import { allowPolicy } from "./security-headers.ts";

const FOLDER = join(import.meta.dirname, "../docs");
const PROTOCOL = join(import.meta.dirname, "../../../../docs/protocol.md");

const FILES = {
  "/docs/docs.css": join(FOLDER, "docs.css"),
  "/docs/docs.js": join(FOLDER, "docs.js"),
  "/docs/swagger-ui.css": fileURLToPath(import.meta.resolve("swagger-ui-dist/swagger-ui.css")),
  "/docs/swagger-ui-bundle.js": fileURLToPath(
    import.meta.resolve("swagger-ui-dist/swagger-ui-bundle.js"),
  ),
};

export function docsRoutes(): Router {
  // Before the routes: a router that ends with another one lets every other request wait for a turn.
  const router = Router().use(ownFiles(FILES));
  const html = readFileSync(join(FOLDER, "docs.html"), "utf8");
  const page = html.replace("<!-- protocol -->", () => htmlOf(readFileSync(PROTOCOL, "utf8")));
  router
    .route("/docs")
    .get((_request, response) => {
      // Swagger UI cleans its markup with DOMPurify, which makes a policy of this name.
      allowPolicy(response, "dompurify");
      response.set("Cache-Control", "no-cache").type("html").send(page);
    })
    .all(methodNotAllowed("GET"));
  return router;
}
