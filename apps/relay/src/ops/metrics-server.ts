/**
 * Serves `/metrics` on a separate port. The public port is often behind a proxy that forwards every
 * path, and process metrics are for the operator only.
 */
import { createServer, type Server } from "node:http";
import type { Logger } from "pino";
import { requireOneHost } from "../platform/http/request-guard.ts";
import { Refusal } from "../platform/errors/problems.ts";
import type { Metrics } from "./metrics.ts";

/** @returns a server that does not listen yet */
export function metricsServer(metrics: Metrics, log: Logger): Server {
  const options = { headersTimeout: 10_000, requestTimeout: 15_000, requireHostHeader: false };
  return createServer(options, (request, response) => {
    try {
      requireOneHost(request);
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      return response.writeHead(400, { "Content-Type": "text/plain" }).end(error.problem.detail);
    }
    if (request.url?.split("?")[0] !== "/metrics") return response.writeHead(404).end();
    if (request.method !== "GET") return response.writeHead(405, { Allow: "GET" }).end();
    void metrics.report().then(
      ({ type, text }) => response.writeHead(200, { "Content-Type": type }).end(text),
      (error: unknown) => {
        log.error({ err: error }, "collecting the metrics failed");
        response.writeHead(500).end();
      },
    );
    return undefined;
  });
}
