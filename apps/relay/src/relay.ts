/** A complete relay: store, robots, HTTP and WebSockets on one port, from start to shutdown. */
import "./platform/process/schema-messages.ts";
import { createServer } from "node:http";
import { join } from "node:path";
import { Router } from "express";
import type { Logger } from "pino";
import { createApp } from "./app.ts";
import { openBackend } from "./open-backend.ts";
import { ClassRegistry } from "./classes/registry.ts";
import type { Clock } from "./platform/time/clock.ts";
import type { Config } from "./config.ts";
import { DocumentService } from "./short-links/document-service.ts";
import { RequestGuard } from "./platform/http/request-guard.ts";
import { answerBrokenRequests } from "./platform/http/broken-requests.ts";
import { CheckSocket } from "./site/check/check-socket.ts";
import { classEndpoint } from "./gateways/conversations/class-endpoint.ts";
import { robotEndpoint } from "./gateways/conversations/endpoint.ts";
import { LongPollConnections } from "./gateways/long-poll/long-poll-connections.ts";
import { RosGateway } from "./gateways/ros/ros-gateway.ts";
import { WebSocketGateway } from "./gateways/websocket/websocket-gateway.ts";
import { closeServer, listen, portOf } from "./platform/http/listening.ts";
import { metricsServer } from "./ops/metrics-server.ts";
import { Metrics } from "./ops/metrics.ts";
import { PairingService } from "./pairing/pairing-service.ts";
import { Readiness } from "./ops/readiness.ts";
import { embeddingHeaders } from "./site/page/embedding.ts";
import { builtPage } from "./site/page/built-page.ts";
import { developmentPage, HOT_RELOAD_PREFIX } from "./site/page/development-page.ts";
import { RobotRegistry } from "./robots/registry.ts";
import { timedStore } from "./store/timed-store.ts";

/**
 * Connections that are still open after this time are destroyed. Process managers kill after 10 s.
 */
const SHUTDOWN_MS = 5_000;

export interface RelayOptions {
  config: Omit<Config, "logLevel">;
  clock: Clock;
  log: Logger;
  /** folder of the web app, with a `dist` folder after a build */
  webRoot: string;
  /** serves the page from its sources, with hot reload */
  isDevelopment: boolean;
}

export interface Relay {
  /** the port that the relay listens on */
  port: number;
  /** the port of /metrics, or null */
  metricsPort: number | null;
  /**
   * Reports not ready, notifies all clients, closes connections and closes the store.
   * @param noticeMs time to continue normally, so that a load balancer stops sending new clients
   * @param hurry ends that time when it is aborted
   */
  close(noticeMs?: number, hurry?: AbortSignal): Promise<void>;
}

/**
 * Starts a relay and waits until it listens.
 * @throws the error of `listen`, such as EADDRINUSE, or of `openBackend`
 */
export async function startRelay(options: RelayOptions): Promise<Relay> {
  const { config, log, webRoot, isDevelopment } = options;
  const backend = await openBackend(config, options.clock, log);
  const { clock } = backend;
  const metrics = new Metrics();
  const store = timedStore(backend.robots, (seconds) => metrics.committed(seconds));
  const documents = new DocumentService(backend.documents, clock, log);
  const registry = new RobotRegistry(store, clock, log, {
    observer: metrics,
    bus: backend.bus,
  });
  const pairing = new PairingService({
    pairings: backend.pairings,
    robots: store,
    clock,
    log,
  });
  const classes = new ClassRegistry({
    store: backend.classes,
    bus: backend.classBus,
    clock,
    log,
  });
  const guard = new RequestGuard(config);
  const readiness = new Readiness(store, clock, log);
  const endpoint = robotEndpoint({ registry, metrics, clock });
  const gateway = new WebSocketGateway({ endpoint, clock, log, guard, metrics });
  const ofClasses = {
    endpoint: classEndpoint({ classes, metrics, clock }),
    clock,
    log,
    guard,
    metrics,
  };
  const classSockets = new WebSocketGateway(ofClasses);
  const classLongPolls = new LongPollConnections(ofClasses);
  const longPolls = new LongPollConnections({ endpoint, clock, log, metrics });
  const checkSocket = new CheckSocket(guard, clock);
  const isRosOn = config.gateways.includes("ros");
  const rosSockets = new RosGateway({ registry, clock, log, guard, metrics, isOn: isRosOn });
  const server = createServer({
    // Old HTTP clients offer "Upgrade: h2c"; that is an ordinary request, not a WebSocket.
    shouldUpgradeCallback: (request) => request.headers.upgrade?.toLowerCase() === "websocket",
    maxHeaderSize: 8 * 1024,
    headersTimeout: 10_000,
    requestTimeout: 15_000,
    // Node checks every 30 s by default, so slow headers would be cut off late.
    connectionsCheckingInterval: 1_000,
    // The request guard checks it, with a clear error message.
    requireHostHeader: false,
  });
  const development = isDevelopment ? await developmentPage(webRoot, server) : null;
  const page = Router();
  page.use(embeddingHeaders(guard, config.embedOrigins));
  page.use(development?.router ?? builtPage(join(webRoot, "dist")));
  const parts = {
    registry,
    classes,
    longPolls,
    classLongPolls,
    documents,
    pairing,
    clock,
    log,
    guard,
    readiness,
    metrics,
  };
  const application = createApp({ ...parts, page, isDevelopment, gateways: config.gateways });
  answerBrokenRequests(server, application, (kind) => metrics.refused(kind));
  server.on("request", application);
  server.on("upgrade", (request, socket, head) => {
    // Vite attaches its own upgrade listener.
    const protocol = request.headers["sec-websocket-protocol"] ?? "";
    const isHotReload = isDevelopment && protocol.startsWith(HOT_RELOAD_PREFIX);
    if (isHotReload) return;
    if (checkSocket.isFor(request)) checkSocket.upgrade(request, socket, head);
    else if (rosSockets.isFor(request)) rosSockets.upgrade(request, socket, head);
    else if (classSockets.isFor(request)) classSockets.upgrade(request, socket, head);
    else gateway.upgrade(request, socket, head);
  });

  const metricsHttp = metricsServer(metrics, log);
  const close = async (noticeMs = 0, hurry?: AbortSignal): Promise<void> => {
    readiness.drain();
    if (noticeMs > 0) {
      await new Promise<void>((resolve) => {
        clock.after(noticeMs, resolve);
        hurry?.addEventListener("abort", () => resolve());
      });
    }
    gateway.close();
    classSockets.close();
    rosSockets.close();
    longPolls.close();
    classLongPolls.close();
    checkSocket.close();
    pairing.close();
    await registry.close();
    await classes.close();
    await development?.close();
    await closeServer(server, SHUTDOWN_MS, () => {
      gateway.destroyAll();
      classSockets.destroyAll();
      rosSockets.destroyAll();
    });
    await closeServer(metricsHttp, 0, () => undefined);
    await documents.close();
    await backend.close();
  };
  try {
    if (config.metricsPort !== null) {
      metrics.observeGauges(async () =>
        Promise.all([registry.connectionCounts(), classes.connectionCounts()]),
      );
      await listen(metricsHttp, config.metricsPort, config.metricsHost);
    }
    await listen(server, config.port, config.host);
  } catch (error) {
    await close();
    throw error;
  }
  return { port: portOf(server) ?? config.port, metricsPort: portOf(metricsHttp), close };
}
