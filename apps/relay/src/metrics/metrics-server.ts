/**
 * `/metrics` on a port of its own. The relay's port is meant for everybody, often through a proxy that
 * passes on every path; figures of the process are for the operator only, so they are not there at all.
 */
import { createServer, type Server } from "node:http";
import type { Logger } from "pino";
import type { Metrics } from "./metrics.ts";

/** @returns a server that does not listen yet */
export function metricsServer(metrics: Metrics, log: Logger): Server {
  return createServer({ headersTimeout: 10_000, requestTimeout: 15_000 }, (request, response) => {
    if (request.url?.split("?")[0] !== "/metrics") return response.writeHead(404).end();
    if (request.method !== "GET") return response.writeHead(405, { Allow: "GET" }).end();
    void metrics.report().then(
      ({ type, text }) => response.writeHead(200, { "Content-Type": type }).end(text),
      (error: unknown) => {
        log.error({ err: error }, "the figures could not be told");
        response.writeHead(500).end();
      },
    );
    return undefined;
  });
}
