/**
 * Files that the build has compressed already, `name.br` and `name.gz` beside `name`: the best one
 * that the browser takes is sent in place of the plain one.
 */
import { existsSync } from "node:fs";
import { extname, join } from "node:path";
import type { RequestHandler, Response } from "express";

/** The best first. */
const encodings = [
  { name: "br", suffix: ".br" },
  { name: "gzip", suffix: ".gz" },
] as const;

/** Turns the request for a file into one for its compressed version, for `express.static` after it. */
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

/** Says of a file that is about to be sent how it is compressed, and what it is beneath that. */
export function tellEncoding(response: Response, path: string): void {
  // What is sent depends on this header even where it is the plain file.
  response.vary("Accept-Encoding");
  const found = encodings.find(({ suffix }) => path.endsWith(suffix));
  if (found === undefined) return;
  response.setHeader("Content-Encoding", found.name);
  response.type(extname(path.slice(0, -found.suffix.length)));
}
