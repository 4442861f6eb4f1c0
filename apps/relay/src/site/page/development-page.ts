/** Serves the page from its sources, with hot reload, on the relay's port. */
import type { Server } from "node:http";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { Router } from "express";
import { PAGE_PATHS } from "./built-page.ts";

/** Prefix of the subprotocols of Vite's hot-reload sockets. */
export const HOT_RELOAD_PREFIX = "vite-";

/**
 * @param root folder of the web app, with index.html and vite.config.ts
 * @param server HTTP server that also serves the hot-reload sockets
 */
export async function developmentPage(
  root: string,
  server: Server,
): Promise<{ router: Router; close(): Promise<void> }> {
  // Imported lazily, because a relay that serves the built page runs without development tools.
  const { createServer } = await import("vite");
  const vite = await createServer({
    root,
    configFile: join(root, "vite.config.ts"),
    appType: "custom",
    server: { middlewareMode: true, ws: { server } },
  });
  const router = Router();
  router.use(vite.middlewares);
  router.get(PAGE_PATHS, async (request, response) => {
    const html = await readFile(join(root, "index.html"), "utf8");
    response.type("html").send(await vite.transformIndexHtml(request.originalUrl, html));
  });
  return { router, close: () => vite.close() };
}
