/** A real relay on a free port with a real database, and requests to it. */
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { registrationSchema, type Registration } from "@corridor/protocol";
import { pino, type Logger } from "pino";
import { onTestFinished } from "vitest";
import { systemClock, type Clock } from "../platform/time/clock.ts";
import { readConfig, type Config } from "../config.ts";
import { startRelay } from "../relay.ts";

/** A log without output. */
export const silentLog: Logger = pino({ level: "silent" });

export interface Requests {
  origin: string;
  register(): Promise<Registration>;
  /** Sends a request with a key to a path below the robot. */
  ask(robot: Registration, path: string, request?: AskOptions): Promise<Response>;
}

export interface TestRelay extends Requests {
  /** the port of /metrics, or null */
  metricsPort: number | null;
  /** @param noticeMs time in which it continues, so that a load balancer notices */
  close(noticeMs?: number): Promise<void>;
}

export interface AskOptions {
  method?: string;
  key?: string;
  body?: unknown;
  headers?: Record<string, string>;
  signal?: AbortSignal;
}

/** A temporary folder, removed after the test. */
export function testFolder(): string {
  const folder = mkdtempSync(join(tmpdir(), "corridor-"));
  onTestFinished(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** The default settings. */
export function defaults(): Config {
  const settings = readConfig({});
  if (!settings.ok) throw new Error("the settings have no defaults");
  return settings.config;
}

/** Starts a relay that ends with the test. */
export async function startTestRelay(
  options: {
    config?: Partial<Config>;
    clock?: Clock;
    log?: Logger;
    dataDir?: string;
    webRoot?: string;
    isDevelopment?: boolean;
  } = {},
): Promise<TestRelay> {
  const dataDir = options.dataDir ?? testFolder();
  const relay = await startRelay({
    config: { ...defaults(), port: 0, host: "127.0.0.1", dataDir, ...options.config },
    clock: options.clock ?? systemClock,
    log: options.log ?? silentLog,
    webRoot: options.webRoot ?? dataDir,
    isDevelopment: options.isDevelopment ?? false,
  });
  let isClosed = false;
  const close = async (noticeMs = 0): Promise<void> => {
    if (isClosed) return;
    isClosed = true;
    await relay.close(noticeMs);
  };
  onTestFinished(() => close());
  const origin = `http://127.0.0.1:${relay.port}`;
  return { ...requestsTo(origin), metricsPort: relay.metricsPort, close };
}

/** Requests to any relay. */
export function requestsTo(origin: string): Requests {
  return {
    origin,
    register: async () => {
      const answer = await fetch(`${origin}/api/v1/robots`, { method: "POST" });
      return registrationSchema.parse(await answer.json());
    },
    ask: (robot, path, { method = "GET", key, body, headers, signal } = {}) =>
      fetch(`${origin}/api/v1/robots/${robot.id}${path}`, {
        method,
        headers: {
          Authorization: `Bearer ${key ?? robot.driverKey}`,
          ...(body !== undefined && { "Content-Type": "application/json" }),
          ...headers,
        },
        ...(body !== undefined && { body: typeof body === "string" ? body : JSON.stringify(body) }),
        ...(signal !== undefined && { signal }),
      }),
  };
}
