/** Serves an explicit list of files for the relay's own small pages, compressed once. */
import { readFile } from "node:fs/promises";
import { promisify } from "node:util";
import { gzip } from "node:zlib";
import { Router } from "express";
import { methodNotAllowed } from "./fallbacks.ts";

const compress = promisify(gzip);

/** @param files file paths by URL path */
export function listedFiles(files: Readonly<Record<string, string>>): Router {
  const router = Router();
  for (const [urlPath, path] of Object.entries(files)) {
    let compressed: Promise<Buffer> | null = null;
    router
      .route(urlPath)
      .get(async (request, response) => {
        response
          .set("Cache-Control", "public, max-age=300")
          .type(path.slice(path.lastIndexOf(".")));
        response.vary("Accept-Encoding");
        if (request.acceptsEncodings("gzip") === false) return response.sendFile(path);
        compressed ??= readFile(path).then((text) => compress(text));
        return response.set("Content-Encoding", "gzip").send(await compressed);
      })
      .all(methodNotAllowed("GET"));
  }
  return router;
}
