/** The page as `npm run build` made it: one document for all its addresses, and its files. */
import { existsSync } from "node:fs";
import { join } from "node:path";
import express, { Router } from "express";
import { Refusal } from "../problems.ts";
import { preferCompressed, tellEncoding } from "./compressed-files.ts";

/** Addresses at which the page shows itself; everything else is a file or nothing. */
export const PAGE_PATHS = ["/", "/r/:id", "/m/:id"];

/** @param folder where the build is, with index.html */
export function builtPage(folder: string): Router {
  const router = Router();
  const assets = join(folder, "assets");
  router.get(PAGE_PATHS, (request, _response, next) => {
    if (!existsSync(join(folder, "index.html"))) {
      throw new Refusal(
        "page-not-built",
        "The page has not been built yet. Run: npm run build (npm start does both).",
      );
    }
    request.url = "/index.html";
    next();
  });
  router.use(preferCompressed(folder));
  router.use(
    express.static(folder, {
      index: false,
      cacheControl: false,
      setHeaders(response, path) {
        tellEncoding(response, path);
        // File names in assets carry a hash of their content, so they never change. All else is
        // asked for each time, the service worker above all: it tells of a new version.
        const isForEver = path.startsWith(assets);
        response.setHeader(
          "Cache-Control",
          isForEver ? "public, max-age=31536000, immutable" : "no-cache",
        );
      },
    }),
  );
  return router;
}
