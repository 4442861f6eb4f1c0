/**
 * Entry point of the relay: reads settings from the environment, starts, and shuts down cleanly.
 */
import "./platform/process/gc-flags.ts";
import "./platform/process/compiled-schemas.ts";
import { join } from "node:path";
import { pino } from "pino";
import { steadyClock } from "./platform/time/clock.ts";
import { addressToOpen, describeConfigProblems, readConfig, type Config } from "./config.ts";
import { startRelay, type Relay } from "./relay.ts";

const PARENT_CHECK_MS = 1_000;
const SAME_PRESS_MS = 500;

function fail(sentence: string, code: number): never {
  process.stderr.write(`${sentence}\n`);
  process.exit(code);
}

function describeStart(error: unknown, config: Config): string {
  // The metrics server has its own port and host, which may be the one in use.
  const usedPort = error instanceof Error && "port" in error ? error.port : config.port;
  const isMetrics = usedPort === config.metricsPort && usedPort !== config.port;
  const name = isMetrics ? "METRICS_PORT" : "PORT";
  const port = (isMetrics ? config.metricsPort : config.port) ?? config.port;
  const host = isMetrics ? config.metricsHost : config.host;
  const code = error instanceof Error && "code" in error ? error.code : undefined;
  if (code === "EADDRINUSE") {
    return `Corridor cannot start: port ${port} is in use. End the other program, or choose another port: ${name}=${port + 1} npm start`;
  }
  if (code === "EACCES" && port < 1024) {
    return `Corridor cannot start: port ${port} is reserved for the system. Choose one above 1023: ${name}=8080 npm start`;
  }
  if (code === "EADDRNOTAVAIL" || code === "ENOTFOUND") {
    return `Corridor cannot start: ${host ?? ""} is not an address of this machine. Check ${isMetrics ? "METRICS_HOST" : "HOST"}.`;
  }
  return `Corridor cannot start: ${error instanceof Error ? error.message : String(error)}`;
}

/**
 * Shuts the relay down on a signal or when npm, its parent process, has exited. Ctrl+C skips the
 * notice period for load balancers. A second signal exits immediately.
 */
function shutDownOnSignal(relay: Relay, noticeMs: number): void {
  let closingSince: number | null = null;
  const hurry = new AbortController();
  const end = (notice: number): void => {
    const now = performance.now();
    if (closingSince !== null) {
      // Under npm one press of Ctrl+C sends two signals, from the terminal and from npm.
      if (now - closingSince > SAME_PRESS_MS) process.exit(1);
      // The signal of npm may be handled first, although the terminal sent its own one before.
      if (notice === 0) hurry.abort();
      return;
    }
    closingSince = now;
    relay.close(notice, hurry.signal).then(
      () => process.exit(0),
      (error: unknown) => fail(`Corridor did not shut down cleanly: ${String(error)}`, 1),
    );
  };
  process.on("SIGTERM", () => end(noticeMs));
  process.on("SIGINT", () => end(0));
  if (process.env["npm_lifecycle_event"] === undefined) return;
  // npm sends SIGTERM to a shell that does not forward it, so the parent exits while this process
  // would stay.
  const parent = process.ppid;
  const timer = setInterval(() => {
    if (process.ppid === parent) return;
    clearInterval(timer);
    if (closingSince === null) end(noticeMs);
  }, PARENT_CHECK_MS);
}

const settings = readConfig(process.env);
if (!settings.ok) fail(describeConfigProblems(settings.problems), 2);
const { config } = settings;
try {
  const log = pino({ level: config.logLevel });
  const relay = await startRelay({
    config,
    clock: steadyClock((ms) =>
      log.warn({ ms }, "wall clock jumped: it was set, or the machine slept"),
    ),
    log,
    webRoot: join(import.meta.dirname, "../../web"),
    isDevelopment: process.argv.includes("--dev"),
  });
  shutDownOnSignal(relay, config.drainSeconds * 1000);
  process.stdout.write(`Corridor is ready: ${addressToOpen(config, relay.port)}\n`);
} catch (error) {
  fail(describeStart(error, config), 1);
}
