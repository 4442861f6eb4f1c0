/**
 * Writes a brotli and a gzip version beside each text file of the build. The relay selects one, and
 * compresses nothing per request.
 */
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { extname, join, resolve } from "node:path";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";
import type { Plugin } from "vite";

const textFiles = new Set([".css", ".html", ".js", ".json", ".svg", ".txt", ".webmanifest"]);
/** Minimum size in bytes: for smaller files, compression saves less than its headers cost. */
const MIN_BYTES = 512;

export function precompress(): Plugin {
  let folder = "";
  return {
    name: "corridor-precompress",
    apply: "build",
    configResolved(config) {
      folder = resolve(config.root, config.build.outDir);
    },
    // Runs after the service worker, which is written after all other files.
    closeBundle: {
      order: "post",
      sequential: true,
      handler(error) {
        if (error === undefined) compressAll(folder);
      },
    },
  };
}

function compressAll(folder: string): void {
  for (const name of readdirSync(folder, { recursive: true, encoding: "utf8" })) {
    if (!textFiles.has(extname(name))) continue;
    const path = join(folder, name);
    const content = readFileSync(path);
    if (content.length < MIN_BYTES) continue;
    writeFileSync(`${path}.br`, smallestBrotli(content));
    writeFileSync(`${path}.gz`, gzipSync(content, { level: 9 }));
  }
}

/** No block size is best for all files: the two differ by some hundred bytes in a first visit. */
function smallestBrotli(content: Buffer): Buffer {
  const hint = { [constants.BROTLI_PARAM_SIZE_HINT]: content.length };
  const [first, second] = [
    brotliCompressSync(content, { params: hint }),
    brotliCompressSync(content, { params: { ...hint, [constants.BROTLI_PARAM_LGBLOCK]: 20 } }),
  ];
  return first.length <= second.length ? first : second;
}
