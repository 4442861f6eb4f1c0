/**
 * `/corridor.js`: the main entry of the TypeScript package as one file. A script or a web page
 * imports it without an installation. `npm run build` makes it.
 */
import { existsSync } from "node:fs";
import { readFile, stat } from "node:fs/promises";
import { basename, dirname, join } from "node:path";
import { promisify } from "node:util";
import { gzip } from "node:zlib";
import { Router } from "express";
import { Refusal } from "../../platform/errors/problems.ts";
import { methodNotAllowed } from "../../platform/http/fallbacks.ts";
import { openToAllSites } from "../../platform/http/security-headers.ts";

const compress = promisify(gzip);

const FILE = join(import.meta.dirname, "../../../dist/corridor.js");

export function javascriptClientRoutes(file: string = FILE): Router {
  const router = Router();
  let compressed: { mtimeMs: number; bytes: Promise<Buffer> } | null = null;
  router
    .route("/corridor.js")
    .all(openToAllSites)
    .get(async (request, response) => {
      if (!existsSync(file)) {
        throw new Refusal(
          "not-found",
          "corridor.js has not been built yet. Run: npm run build (npm start does both).",
        );
      }
      response.set("Cache-Control", "no-cache").type("text/javascript; charset=utf-8");
      response.vary("Accept-Encoding");
      if (request.acceptsEncodings("gzip") === false) {
        return response.sendFile(basename(file), { root: dirname(file), cacheControl: false });
      }
      const { mtime, mtimeMs } = await stat(file);
      if (compressed?.mtimeMs !== mtimeMs) {
        compressed = { mtimeMs, bytes: readFile(file).then((source) => compress(source)) };
      }
      response.set({ "Content-Encoding": "gzip", "Last-Modified": mtime.toUTCString() });
      return response.send(await compressed.bytes);
    })
    .all(methodNotAllowed("GET"));
  return router;
}
