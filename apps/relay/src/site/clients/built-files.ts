/**
 * Files that `npm run build` makes, each a program without dependencies:
 *
 * - `/corridor.js`: the main entry of the TypeScript package, which a script or a web page imports
 * - `/corridor-cli.mjs`: the command `corridor`, which runs bridges with Node.js
 * - `/grade.mjs`: the command `grade`, which a build server runs with Node.js
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

const FOLDER = join(import.meta.dirname, "../../../dist");

export function builtFileRoutes(): Router {
  const router = Router();
  for (const name of ["corridor.js", "corridor-cli.mjs", "grade.mjs"]) {
    router.use(builtFileRoute(join(FOLDER, name)));
  }
  return router;
}

/** Serves a JavaScript file under its name. */
export function builtFileRoute(file: string): Router {
  const router = Router();
  const name = basename(file);
  let compressed: { mtimeMs: number; bytes: Promise<Buffer> } | null = null;
  router
    .route(`/${name}`)
    .all(openToAllSites)
    .get(async (request, response) => {
      if (!existsSync(file)) {
        throw new Refusal(
          "not-found",
          `${name} has not been built yet. Run: npm run build (npm start does both).`,
        );
      }
      response.set("Cache-Control", "no-cache").type("text/javascript; charset=utf-8");
      response.vary("Accept-Encoding");
      if (request.acceptsEncodings("gzip") === false) {
        return response.sendFile(name, { root: dirname(file), cacheControl: false });
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
