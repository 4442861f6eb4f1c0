/**
 * Logs one line for each finished request at level info. It contains the route pattern in place of
 * the path, because a path, query or header may contain a key. Of a key it contains 6 characters of
 * the hash, and it contains no IP address.
 */
import type { RequestHandler } from "express";
import type { Logger } from "pino";
import type { Clock } from "../time/clock.ts";
import { markOf } from "../keys.ts";
import { readBearer, readClient } from "./reading.ts";

export function requestLog(log: Logger, clock: Clock): RequestHandler {
  return (request, response, next) => {
    if (!log.isLevelEnabled("info")) return next();
    const arrivedAt = clock.now();
    response.once("close", () => {
      const route = request.route as { path?: unknown } | undefined;
      const line = {
        method: request.method,
        route: typeof route?.path === "string" ? route.path : null,
        status: response.statusCode,
        ms: clock.now() - arrivedAt,
        client: readClient(request),
        key: markOf(readBearer(request)),
      };
      log.info(
        line,
        response.writableFinished
          ? "request completed"
          : "client disconnected before the response ended",
      );
    });
    return next();
  };
}
