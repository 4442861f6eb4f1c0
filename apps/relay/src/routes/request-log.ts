/**
 * One line of log for each request that has ended, at level info. It tells the pattern of the route
 * instead of the path, because whatever stands in a path, query or header may be somebody's key; of a
 * key that was sent it tells 6 characters of the hash, and of the visitor no address.
 */
import type { RequestHandler } from "express";
import type { Logger } from "pino";
import type { Clock } from "../clock.ts";
import { markOf } from "../keys.ts";
import { readBearer, readClient } from "./reading.ts";

export function requestLog(log: Logger, clock: Clock): RequestHandler {
  return (request, response, next) => {
    if (!log.isLevelEnabled("info")) return next();
    const cameAt = clock.now();
    response.once("close", () => {
      const route = request.route as { path?: unknown } | undefined;
      const line = {
        method: request.method,
        route: typeof route?.path === "string" ? route.path : null,
        status: response.statusCode,
        ms: clock.now() - cameAt,
        client: readClient(request),
        key: markOf(readBearer(request)),
      };
      log.info(line, response.writableFinished ? "answered" : "cut off before the end");
    });
    return next();
  };
}
