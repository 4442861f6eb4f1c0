/** Entry of the relay: settings from the environment, start, and an orderly end. */
import { join } from "node:path";
import { pino } from "pino";
import { systemClock } from "./clock.ts";
import { addressToOpen, describeConfigProblems, readConfig, type Config } from "./config.ts";
import { startRelay, type Relay } from "./relay.ts";

const PARENT_CHECK_MS = 1_000;

function fail(sentence: string, code: number): never {
  process.stderr.write(`${sentence}\n`);
  process.exit(code);
}

function describeStart(error: unknown, { port, host }: Config): string {
  const code = error instanceof Error && "code" in error ? error.code : undefined;
  if (code === "EADDRINUSE") {
    return `Corridor cannot start: port ${port} is in use. End the other program, or choose another port: PORT=${port + 1} npm start`;
  }
  if (code === "EACCES" && port < 1024) {
    return `Corridor cannot start: port ${port} is reserved for the system. Choose one above 1023: PORT=8080 npm start`;
  }
  if (code === "EADDRNOTAVAIL" || code === "ENOTFOUND") {
    return `Corridor cannot start: ${host ?? ""} is no address of this machine. Check HOST.`;
  }
  return `Corridor cannot start: ${error instanceof Error ? error.message : String(error)}`;
}

/** Ends the relay once, on a signal or when npm, its parent, is gone. */
function endOrderly(relay: Relay): void {
  let isEnding = false;
  const end = (): void => {
    if (isEnding) return;
    isEnding = true;
    void relay.close().then(() => process.exit(0));
  };
  process.on("SIGTERM", end);
  process.on("SIGINT", end);
  if (process.env["npm_lifecycle_event"] === undefined) return;
  // npm passes SIGTERM to a shell that does not pass it on: the parent goes, this process would stay.
  const parent = process.ppid;
  setInterval(() => {
    if (process.ppid !== parent) end();
  }, PARENT_CHECK_MS);
}

const settings = readConfig(process.env);
if (!settings.ok) fail(describeConfigProblems(settings.problems), 2);
const { config } = settings;
try {
  const relay = await startRelay({
    config,
    clock: systemClock,
    log: pino({ level: config.logLevel }),
    webRoot: join(import.meta.dirname, "../../web"),
    isDevelopment: process.argv.includes("--dev"),
  });
  endOrderly(relay);
  process.stdout.write(`Corridor is ready: ${addressToOpen(config, relay.port)}\n`);
} catch (error) {
  fail(describeStart(error, config), 1);
}
