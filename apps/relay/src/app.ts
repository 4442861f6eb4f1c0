/** The HTTP application: API, health and page, without a port of its own. */
import express, { Router, type Express } from "express";
import type { Logger } from "pino";
import type { Clock } from "./clock.ts";
import type { DocumentShelf } from "./documents/document-shelf.ts";
import type { Entrance } from "./entrance/entrance.ts";
import type { HttpLines } from "./gateways/http-lines.ts";
import type { Metrics } from "./metrics/metrics.ts";
import type { PairingDesk } from "./pairing/pairing-desk.ts";
import type { Readiness } from "./readiness.ts";
import { checkRoutes } from "./routes/check.ts";
import { commandRoutes } from "./routes/commands.ts";
import { descriptionRoutes } from "./routes/description.ts";
import { docsRoutes } from "./routes/docs.ts";
import { documentRoutes } from "./routes/documents.ts";
import { eventRoutes } from "./routes/events.ts";
import { notFound, problemAnswers } from "./routes/fallbacks.ts";
import { healthRoutes } from "./routes/health.ts";
import { pythonClientRoutes } from "./routes/python-client.ts";
import { keyRoutes } from "./routes/keys.ts";
import { lineRoutes } from "./routes/lines.ts";
import { mazeRoutes } from "./routes/maze.ts";
import { pairingRoutes } from "./routes/pairing.ts";
import { requestLog } from "./routes/request-log.ts";
import { robotRoutes } from "./routes/robots.ts";
import { openToAllSites, securityHeaders } from "./routes/security-headers.ts";
import { scriptRoutes } from "./routes/scripts.ts";
import { sensorRoutes } from "./routes/sensors.ts";
import { unreadableAddress, wrongAddress } from "./routes/wrong-address.ts";
import type { SessionHub } from "./sessions/session-hub.ts";

export interface AppDependencies {
  hub: SessionHub;
  lines: HttpLines;
  documents: DocumentShelf;
  pairing: PairingDesk;
  clock: Clock;
  log: Logger;
  entrance: Entrance;
  readiness: Readiness;
  metrics: Metrics;
  /** serves the page */
  page: Router;
  isDevelopment: boolean;
}

/** Builds the application from its parts. */
export function createApp(dependencies: AppDependencies): Express {
  const { hub, lines, documents, pairing, clock, log, entrance, readiness } = dependencies;
  const { metrics, page, isDevelopment } = dependencies;
  const app = express();
  app.disable("x-powered-by");
  app.set("query parser", "simple");
  app.set("etag", false);
  app.use(securityHeaders(isDevelopment));

  // Before the check of the name: machines that watch over this one ask by its bare address.
  app.use(healthRoutes(readiness));
  app.use(requestLog(log, clock));
  app.use((request, _response, next) => {
    entrance.checkHost(request);
    next();
  });
  app.use(descriptionRoutes());
  app.use(docsRoutes());
  app.use(checkRoutes(entrance, clock));
  app.use(pythonClientRoutes());
  const api = Router();
  api.use(openToAllSites);
  api.use(robotRoutes(hub, entrance));
  api.use(keyRoutes(hub, entrance));
  api.use(pairingRoutes(hub, pairing, entrance));
  api.use(scriptRoutes(hub));
  api.use(sensorRoutes(hub));
  api.use(mazeRoutes(hub));
  api.use(commandRoutes(hub));
  api.use(eventRoutes(hub, clock));
  api.use(lineRoutes(lines, entrance));
  api.use(documentRoutes(documents, entrance));
  api.use(notFound);
  app.use("/api/v1", api);

  app.use(page);
  app.use(unreadableAddress);
  app.use(wrongAddress(() => metrics.refused("not-found")));
  app.use(notFound);
  app.use(problemAnswers(log, (kind) => metrics.refused(kind)));
  return app;
}
