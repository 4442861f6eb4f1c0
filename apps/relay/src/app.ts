/** The HTTP application: API, health and page, without a port of its own. */
import express, { Router, type Express } from "express";
import type { Logger } from "pino";
import type { Clock } from "./clock.ts";
import type { Health } from "./routes/answers.ts";
import { commandRoutes } from "./routes/commands.ts";
import { descriptionRoutes } from "./routes/description.ts";
import { eventRoutes } from "./routes/events.ts";
import { notFound, problemAnswers } from "./routes/fallbacks.ts";
import { robotRoutes } from "./routes/robots.ts";
import { openToAllSites, securityHeaders } from "./routes/security-headers.ts";
import { sensorRoutes } from "./routes/sensors.ts";
import type { SessionHub } from "./sessions/session-hub.ts";

export interface AppDependencies {
  hub: SessionHub;
  clock: Clock;
  log: Logger;
  /** origin under which the service is reached from outside; null: what each request says */
  publicOrigin: string | null;
  /** serves the page */
  page: Router;
  isDevelopment: boolean;
}

/** Builds the application from its parts. */
export function createApp(dependencies: AppDependencies): Express {
  const { hub, clock, log, publicOrigin, page, isDevelopment } = dependencies;
  const app = express();
  app.disable("x-powered-by");
  app.set("query parser", "simple");
  app.set("etag", false);
  app.use(securityHeaders(isDevelopment));

  app.get("/healthz", (_request, response) => {
    const health: Health = { status: "ok" };
    response.set("Cache-Control", "no-store").json(health);
  });
  app.use(descriptionRoutes());
  const api = Router();
  api.use(openToAllSites);
  api.use(robotRoutes(hub, publicOrigin));
  api.use(sensorRoutes(hub));
  api.use(commandRoutes(hub));
  api.use(eventRoutes(hub, clock));
  api.use(notFound);
  app.use("/api/v1", api);

  app.use(page);
  app.use(notFound);
  app.use(problemAnswers(log));
  return app;
}
