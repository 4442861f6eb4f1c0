/** Entry of the relay: settings from the environment, start, and an orderly end. */
import "./garbage.ts";
import "./compiled-schemas.ts";
import { join } from "node:path";
import { pino } from "pino";
import { steadyClock } from "./clock.ts";
import { addressToOpen, describeConfigProblems, readConfig, type Config } from "./config.ts";
import { startRelay, type Relay } from "./relay.ts";

const PARENT_CHECK_MS = 1_000;
const SAME_PRESS_MS = 500;

function fail(sentence: string, code: number): never {
  process.stderr.write(`${sentence}\n`);
  process.exit(code);
}

function describeStart(error: unknown, config: Config): string {
  // The metrics have a port and a host of their own, which may be the one that is taken.
  const taken = error instanceof Error && "port" in error ? error.port : config.port;
  const isMetrics = taken === config.metricsPort && taken !== config.port;
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
    return `Corridor cannot start: ${host ?? ""} is no address of this machine. Check ${isMetrics ? "METRICS_HOST" : "HOST"}.`;
  }
  return `Corridor cannot start: ${error instanceof Error ? error.message : String(error)}`;
}

/**
 * Ends the relay on a signal or when npm, its parent, is gone. Ctrl+C does not wait for balancers, and a
 * second signal waits for nobody.
 */
function endOrderly(relay: Relay, noticeMs: number): void {
  let endingSince: number | null = null;
  const end = (notice: number): void => {
    const now = performance.now();
    if (endingSince !== null) {
      // Under npm one press of Ctrl+C comes twice: from the terminal and from npm.
      if (now - endingSince > SAME_PRESS_MS) process.exit(1);
      return;
    }
    endingSince = now;
    relay.close(notice).then(
      () => process.exit(0),
      (error: unknown) => fail(`Corridor did not end in order: ${String(error)}`, 1),
    );
  };
  process.on("SIGTERM", () => end(noticeMs));
  process.on("SIGINT", () => end(0));
  if (process.env["npm_lifecycle_event"] === undefined) return;
  // npm passes SIGTERM to a shell that does not pass it on: the parent goes, this process would stay.
  const parent = process.ppid;
  const timer = setInterval(() => {
    if (process.ppid === parent) return;
    clearInterval(timer);
    if (endingSince === null) end(noticeMs);
  }, PARENT_CHECK_MS);
}

const settings = readConfig(process.env);
if (!settings.ok) fail(describeConfigProblems(settings.problems), 2);
const { config } = settings;
try {
  const log = pino({ level: config.logLevel });
  const relay = await startRelay({
    config,
    clock: steadyClock((ms) => log.warn({ ms }, "the machine's clock was set, or it slept")),
    log,
    webRoot: join(import.meta.dirname, "../../web"),
    isDevelopment: process.argv.includes("--dev"),
  });
  endOrderly(relay, config.drainSeconds * 1000);
  process.stdout.write(`Corridor is ready: ${addressToOpen(config, relay.port)}\n`);
} catch (error) {
  fail(describeStart(error, config), 1);
}
