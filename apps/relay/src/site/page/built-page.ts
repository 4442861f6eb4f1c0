/**
 * Serves the build of `npm run build`: one HTML document for all paths of the page, and its files.
 */
import { existsSync } from "node:fs";
import { join } from "node:path";
import express, { Router } from "express";
import { EMBED_PATHS } from "./embedding.ts";
import { Refusal } from "../../platform/errors/problems.ts";
import { preferCompressed, setEncodingHeaders } from "./compressed-files.ts";

/** Paths of the page. Every other path is a file or does not exist. */
export const PAGE_PATHS = [
  "/",
  "/r/:id",
  "/m/:id",
  "/teach",
  "/join",
  "/class/:id",
  ...EMBED_PATHS,
];

/** @param folder the build folder, with index.html */
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
        setEncodingHeaders(response, path);
        // File names in assets contain a hash of their content, so they never change. All other
        // files are revalidated, above all the service worker, which detects a new version.
        const isImmutable = path.startsWith(assets);
        response.setHeader(
          "Cache-Control",
          isImmutable ? "public, max-age=31536000, immutable" : "no-cache",
        );
      },
    }),
  );
  return router;
}
