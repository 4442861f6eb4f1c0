/** The HTTP application: API, health and page, without a port of its own. */
import type { ClassHello, Hello, GatewayName } from "@corridor/protocol";
import express, { Router, type Express, type RequestHandler } from "express";
import type { Logger } from "pino";
import type { Clock } from "./platform/time/clock.ts";
import type { DocumentService } from "./short-links/document-service.ts";
import { requireOneHost, type RequestGuard } from "./platform/http/request-guard.ts";
import type { LongPollConnections } from "./gateways/long-poll/long-poll-connections.ts";
import type { Metrics } from "./ops/metrics.ts";
import type { PairingService } from "./pairing/pairing-service.ts";
import type { Readiness } from "./ops/readiness.ts";
import { classRoutes } from "./gateways/rest/classes/routes.ts";
import type { ClassRegistry } from "./classes/registry.ts";
import { checkRoutes } from "./site/check/check.ts";
import { commandRoutes } from "./gateways/rest/commands/routes.ts";
import { descriptionRoutes } from "./site/description.ts";
import { docsRoutes } from "./site/docs/docs.ts";
import { documentRoutes } from "./gateways/rest/short-links/routes.ts";
import { eventRoutes } from "./gateways/sse/routes.ts";
import { gatewayRefusals, notFound, problemResponses } from "./platform/http/fallbacks.ts";
import { healthRoutes } from "./ops/health.ts";
import { pythonClientRoutes } from "./site/clients/python-client.ts";
import { builtFileRoutes } from "./site/clients/built-files.ts";
import { keyRoutes } from "./gateways/rest/keys/routes.ts";
import { longPollRoutes } from "./gateways/long-poll/routes.ts";
import { MCP_PATH, mcpRoutes } from "./gateways/mcp/routes.ts";
import { refuseDisabled } from "./gateways/requests/gateway-requests.ts";
import { rosRoutes } from "./gateways/ros/routes.ts";
import { mazeRoutes } from "./gateways/rest/maze/routes.ts";
import { pairingRoutes } from "./gateways/rest/pairing/routes.ts";
import { oembedRoutes } from "./gateways/rest/embedding/routes.ts";
import { requestLog } from "./platform/http/request-log.ts";
import { robotRoutes } from "./gateways/rest/robots/routes.ts";
import { openToAllSites, securityHeaders } from "./platform/http/security-headers.ts";
import { scriptRoutes } from "./gateways/rest/scripts/routes.ts";
import { sensorRoutes } from "./gateways/rest/sensors/routes.ts";
import { SOAP_PATH, soapRoutes } from "./gateways/soap/routes.ts";
import { unreadableAddress, wrongAddress } from "./site/wrong-address.ts";
import type { RobotRegistry } from "./robots/registry.ts";

export interface AppDependencies {
  registry: RobotRegistry;
  classes: ClassRegistry;
  longPolls: LongPollConnections<Hello>;
  classLongPolls: LongPollConnections<ClassHello>;
  documents: DocumentService;
  pairing: PairingService;
  clock: Clock;
  log: Logger;
  guard: RequestGuard;
  readiness: Readiness;
  metrics: Metrics;
  /** serves the page */
  page: Router;
  isDevelopment: boolean;
  /** those that the operator has not switched off */
  gateways: readonly GatewayName[];
}

/** Builds the application from its parts. */
export function createApp(dependencies: AppDependencies): Express {
  const { registry, classes, longPolls, documents, pairing, clock, log, guard, readiness } =
    dependencies;
  const { classLongPolls, metrics, page, isDevelopment, gateways } = dependencies;
  const app = express();
  app.disable("x-powered-by");
  app.set("query parser", "simple");
  app.set("etag", false);
  app.use(securityHeaders(isDevelopment));

  app.use((request, _response, next) => {
    requireOneHost(request);
    next();
  });
  // Before the host check: health probes use the bare address of the machine.
  app.use(healthRoutes(readiness));
  app.use(requestLog(log, clock));
  app.use((request, _response, next) => {
    guard.checkHost(request);
    next();
  });
  app.use(descriptionRoutes());
  app.use(docsRoutes(gateways));
  app.use(checkRoutes(guard, clock));
  app.use(pythonClientRoutes());
  app.use(builtFileRoutes());
  const api = Router();
  api.use(openToAllSites);
  api.use(robotRoutes(registry, guard, gateways));
  api.use(keyRoutes(registry, guard, gateways));
  api.use(pairingRoutes(registry, pairing, guard));
  api.use(scriptRoutes(registry));
  api.use(sensorRoutes(registry));
  api.use(mazeRoutes(registry));
  api.use(commandRoutes(registry));
  api.use(eventRoutes(registry, clock));
  api.use(longPollRoutes(longPolls, guard));
  api.use(documentRoutes(documents, guard));
  api.use(oembedRoutes(documents, guard));
  api.use(classRoutes(classes, guard));
  api.use(longPollRoutes(classLongPolls, guard));
  api.use(notFound);
  app.use("/api/v1", api);
  const onRefused = gatewayRefusals(log, (kind) => metrics.refused(kind));
  const counted =
    (gateway: GatewayName): RequestHandler =>
    (_request, _response, next) => {
      metrics.gatewayMessage(gateway);
      next();
    };
  if (gateways.includes("mcp")) {
    app.use(MCP_PATH, counted("mcp"));
    app.use(mcpRoutes(registry, guard, onRefused));
  } else {
    app.use(MCP_PATH, refuseDisabled("mcp"));
  }
  if (gateways.includes("soap")) {
    app.post(SOAP_PATH, counted("soap"));
    app.use(soapRoutes(registry, guard, onRefused));
  } else {
    app.use(SOAP_PATH, refuseDisabled("soap"));
  }
  app.use(rosRoutes(gateways));

  app.use(page);
  app.use(unreadableAddress);
  app.use(wrongAddress(() => metrics.refused("not-found")));
  app.use(notFound);
  app.use(problemResponses(log, (kind) => metrics.refused(kind)));
  return app;
}
