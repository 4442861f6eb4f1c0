/** Builds the page of the variants in the same way as the product, and serves it on a free port. */
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { build, preview } from "vite";

export interface PageServer {
  /** without a trailing slash */
  url: string;
  stop: () => Promise<void>;
}

/** @param folder folder with an index.html, relative to this file */
export async function serveVariants(folder: string): Promise<PageServer> {
  const root = fileURLToPath(new URL(folder, import.meta.url));
  const outDir = mkdtempSync(join(tmpdir(), "corridor-variants-"));
  await build({
    root,
    configFile: false,
    logLevel: "error",
    define: { "process.env.NODE_ENV": '"production"' },
    worker: { format: "es" },
    build: { outDir, emptyOutDir: true, chunkSizeWarningLimit: 1000 },
  });
  const server = await preview({
    root,
    configFile: false,
    logLevel: "warn",
    build: { outDir },
    preview: { port: 0, host: "127.0.0.1" },
  });
  const address = server.httpServer.address();
  if (address === null || typeof address === "string") {
    throw new Error("The server of the variants has no port.");
  }
  return {
    url: `http://127.0.0.1:${address.port}`,
    stop: async () => {
      await server.close();
      rmSync(outDir, { recursive: true, force: true });
    },
  };
}
