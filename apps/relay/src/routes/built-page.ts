/** The page as `npm run build` made it: one document for all its addresses, and its files. */
import { existsSync } from "node:fs";
import { join } from "node:path";
import express, { Router } from "express";
import { Refusal } from "../problems.ts";

/** Addresses at which the page shows itself; everything else is a file or nothing. */
const PAGE_PATHS = ["/", "/r/:id"];

/** @param folder where the build is, with index.html */
export function builtPage(folder: string): Router {
  const router = Router();
  const index = join(folder, "index.html");
  router.get(PAGE_PATHS, (_request, response) => {
    if (!existsSync(index)) {
      throw new Refusal(
        "page-not-built",
        "The page has not been built yet. Run: npm run build (npm start does both).",
      );
    }
    response.set("Cache-Control", "no-cache").sendFile(index);
  });
  // File names in assets carry a hash of their content, so they never change.
  router.use(
    "/assets",
    express.static(join(folder, "assets"), { immutable: true, maxAge: "1y", index: false }),
  );
  router.use(express.static(folder, { index: false }));
  return router;
}
