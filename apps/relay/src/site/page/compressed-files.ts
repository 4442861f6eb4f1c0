/**
 * Serves the compressed versions that the build wrote, `name.br` and `name.gz` beside `name`: the
 * best encoding that the browser accepts replaces the plain file.
 */
import { existsSync } from "node:fs";
import { extname, join } from "node:path";
import type { RequestHandler, Response } from "express";

/** Best first. */
const encodings = [
  { name: "br", suffix: ".br" },
  { name: "gzip", suffix: ".gz" },
] as const;

/** Rewrites a request for a file to its compressed version, for the following `express.static`. */
export function preferCompressed(folder: string): RequestHandler {
  return (request, _response, next) => {
    const { path } = request;
    if ((request.method !== "GET" && request.method !== "HEAD") || !/^\/[\w./-]+$/.test(path)) {
      return next();
    }
    const found = encodings.find(
      ({ name, suffix }) =>
        request.acceptsEncodings(name) !== false && existsSync(join(folder, path + suffix)),
    );
    if (found !== undefined) request.url = path + found.suffix;
    return next();
  };
}

/** Sets the Content-Encoding and the Content-Type of the uncompressed file. */
export function setEncodingHeaders(response: Response, path: string): void {
  // The response depends on this header even if it is the plain file.
  response.vary("Accept-Encoding");
  const found = encodings.find(({ suffix }) => path.endsWith(suffix));
  if (found === undefined) return;
  response.setHeader("Content-Encoding", found.name);
  response.type(extname(path.slice(0, -found.suffix.length)));
}
