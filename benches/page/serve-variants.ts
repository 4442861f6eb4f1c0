/** Builds a page of variants as the product is built, and serves it on a free port. */
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { build, preview } from "vite";

/** An address without a slash at its end, and how to stop serving it. */
export interface Served {
  url: string;
  stop: () => Promise<void>;
}

/** @param folder with an index.html, from here */
export async function serveVariants(folder: string): Promise<Served> {
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
  if (address === null || typeof address === "string") throw new Error("the variants have no port");
  return {
    url: `http://127.0.0.1:${address.port}`,
    stop: async () => {
      await server.close();
      rmSync(outDir, { recursive: true, force: true });
    },
  };
}
