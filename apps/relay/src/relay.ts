/** A whole relay: store, sessions, HTTP and WebSockets on one port, from start to shutdown. */
import "./expected-words.ts";
import { createServer } from "node:http";
import { join } from "node:path";
import type { Router } from "express";
import type { Logger } from "pino";
import { createApp } from "./app.ts";
import { openBacking } from "./backing.ts";
import type { Clock } from "./clock.ts";
import type { Config } from "./config.ts";
import { DocumentShelf } from "./documents/document-shelf.ts";
import { Entrance } from "./entrance/entrance.ts";
import { answerBrokenRequests } from "./gateways/broken-requests.ts";
import { CheckSocket } from "./gateways/check-socket.ts";
import { HttpLines } from "./gateways/http-lines.ts";
import { WebSocketGateway } from "./gateways/websocket-gateway.ts";
import { closeServer, listen, portOf } from "./listening.ts";
import { metricsServer } from "./metrics/metrics-server.ts";
import { Metrics } from "./metrics/metrics.ts";
import { PairingDesk } from "./pairing/pairing-desk.ts";
import { Readiness } from "./readiness.ts";
import { builtPage } from "./routes/built-page.ts";
import { developmentPage, HOT_RELOAD_PREFIX } from "./routes/development-page.ts";
import { SessionHub } from "./sessions/session-hub.ts";
import { timedStore } from "./store/timed-store.ts";

/** Whoever has not ended so long after being told is cut off: process managers kill after 10 s. */
const SHUTDOWN_MS = 5_000;

export interface RelayOptions {
  config: Omit<Config, "logLevel">;
  clock: Clock;
  log: Logger;
  /** folder of the web app, with `dist` when it was built */
  webRoot: string;
  /** serve the page from its sources, with hot reload */
  isDevelopment: boolean;
}

export interface Relay {
  /** the port it listens on */
  port: number;
  /** the port of /metrics, or null */
  metricsPort: number | null;
  /**
   * Says that it is not ready, then tells everyone, ends what is open and closes the store.
   * @param noticeMs how long all goes on as before, so that a balancer sees it and sends nobody new
   */
  close(noticeMs?: number): Promise<void>;
}

/**
 * Starts a relay and waits until it listens.
 * @throws the error of `listen`, such as EADDRINUSE, or of `openBacking`
 */
export async function startRelay(options: RelayOptions): Promise<Relay> {
  const { config, log, webRoot, isDevelopment } = options;
  const backing = await openBacking(config, options.clock, log);
  const { clock } = backing;
  const metrics = new Metrics();
  const store = timedStore(backing.sessions, (seconds) => metrics.committed(seconds));
  const documents = new DocumentShelf(backing.documents, clock, log);
  const hub = new SessionHub(store, clock, log, {
    witness: metrics,
    switchboard: backing.switchboard,
  });
  const pairing = new PairingDesk({
    pairings: backing.pairings,
    sessions: store,
    clock,
    log,
  });
  const entrance = new Entrance(config);
  const readiness = new Readiness(store, clock, log);
  const gateway = new WebSocketGateway({ hub, clock, log, entrance, metrics });
  const lines = new HttpLines({ hub, clock, log, metrics });
  const checkSocket = new CheckSocket(entrance, clock);
  const server = createServer({
    // Old HTTP clients offer "Upgrade: h2c"; that is an ordinary request, not a WebSocket.
    shouldUpgradeCallback: (request) => request.headers.upgrade?.toLowerCase() === "websocket",
    maxHeaderSize: 8 * 1024,
    headersTimeout: 10_000,
    requestTimeout: 15_000,
    // Node looks every 30 s otherwise: who sends a header a minute would be cut off late.
    connectionsCheckingInterval: 1_000,
    // The entrance asks for it, and says so in words.
    requireHostHeader: false,
  });
  const development = isDevelopment ? await developmentPage(webRoot, server) : null;
  const page: Router = development?.router ?? builtPage(join(webRoot, "dist"));
  const parts = { hub, lines, documents, pairing, clock, log, entrance, readiness, metrics };
  const application = createApp({ ...parts, page, isDevelopment });
  answerBrokenRequests(server, application, (kind) => metrics.refused(kind));
  server.on("request", application);
  server.on("upgrade", (request, socket, head) => {
    // Vite listens for its own socket by itself.
    const protocol = request.headers["sec-websocket-protocol"] ?? "";
    const isHotReload = isDevelopment && protocol.startsWith(HOT_RELOAD_PREFIX);
    if (isHotReload) return;
    if (checkSocket.isFor(request)) checkSocket.upgrade(request, socket, head);
    else gateway.upgrade(request, socket, head);
  });

  const figures = metricsServer(metrics, log);
  const close = async (noticeMs = 0): Promise<void> => {
    readiness.drain();
    if (noticeMs > 0) await new Promise<void>((resolve) => clock.after(noticeMs, resolve));
    gateway.close();
    lines.close();
    checkSocket.close();
    pairing.close();
    await hub.close();
    await development?.close();
    await closeServer(server, SHUTDOWN_MS, () => gateway.cut());
    await closeServer(figures, 0, () => undefined);
    await documents.close();
    await backing.close();
  };
  try {
    if (config.metricsPort !== null) {
      metrics.watch(() => hub.census());
      await listen(figures, config.metricsPort, config.metricsHost);
    }
    await listen(server, config.port, config.host);
  } catch (error) {
    await close();
    throw error;
  }
  return { port: portOf(server) ?? config.port, metricsPort: portOf(figures), close };
}
