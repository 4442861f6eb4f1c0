/**
 * `/docs`: how to write a script, the whole protocol, and a console to try the calls in. All of it comes
 * from here, so that it works without any other network; the policy is that of every page.
 */
import { readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { gzip } from "node:zlib";
import { Router } from "express";
import { htmlOf } from "../docs/markdown.ts";
import { methodNotAllowed } from "./fallbacks.ts";

const FOLDER = join(import.meta.dirname, "../docs");
const PROTOCOL = join(import.meta.dirname, "../../../../docs/protocol.md");

/** What the page loads, by name. */
const FILES: Record<string, string> = {
  "docs.css": join(FOLDER, "docs.css"),
  "docs.js": join(FOLDER, "docs.js"),
  "swagger-ui.css": fileURLToPath(import.meta.resolve("swagger-ui-dist/swagger-ui.css")),
  "swagger-ui-bundle.js": fileURLToPath(
    import.meta.resolve("swagger-ui-dist/swagger-ui-bundle.js"),
  ),
};

const compress = promisify(gzip);

export function docsRoutes(): Router {
  const router = Router();
  const html = readFileSync(join(FOLDER, "docs.html"), "utf8");
  const page = html.replace("<!-- protocol -->", () => htmlOf(readFileSync(PROTOCOL, "utf8")));
  router
    .route("/docs")
    .get((_request, response) => {
      response.set("Cache-Control", "no-cache").type("html").send(page);
    })
    .all(methodNotAllowed("GET"));
  for (const [name, path] of Object.entries(FILES)) {
    let compressed: Promise<Buffer> | null = null;
    router
      .route(`/docs/${name}`)
      .get(async (request, response) => {
        response.set("Cache-Control", "public, max-age=300").type(name).vary("Accept-Encoding");
        if (request.acceptsEncodings("gzip") === false) return response.sendFile(path);
        compressed ??= readFile(path).then((text) => compress(text));
        return response.set("Content-Encoding", "gzip").send(await compressed);
      })
      .all(methodNotAllowed("GET"));
  }
  return router;
}
