/**
 * Finds the Redis or Valkey server for tests and `npm run start:cluster`, or installs it if no
 * confirmation is needed. Starts it with persistence.
 */
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { freePort } from "./free-port.ts";
import { inPath, tryInstall } from "./programs.ts";

const START_MS = 10_000;
const NOT_FOUND =
  "Redis is needed. Install it (Debian, Ubuntu: `apt-get install redis-server`; macOS: `brew install redis`), or set REDIS_SERVER_PATH to a redis-server or valkey-server.";

export interface RedisServer {
  /** such as redis://127.0.0.1:6379 */
  url: string;
  port: number;
  pid: number;
  /** Resolves when the process has ended for any reason. */
  ended: Promise<void>;
  /** Stops the server. Its data stay in its folder. */
  stop(signal?: "SIGTERM" | "SIGKILL"): Promise<void>;
}

/** @returns the path of a server, or null. `REDIS_SERVER_PATH` takes precedence. */
export function findRedis(): string | null {
  const configured = process.env["REDIS_SERVER_PATH"] ?? "";
  const candidates = [configured, ...["redis-server", "valkey-server"].flatMap(inPath)];
  return candidates.find((path) => path !== "" && existsSync(path)) ?? null;
}

/**
 * Finds a server, or installs one if the machine allows that.
 * @throws Error with installation instructions
 */
export function requireRedis(): string {
  const found = findRedis() ?? (tryInstall("redis-server") ? findRedis() : null);
  if (found === null) throw new Error(NOT_FOUND);
  return found;
}

/**
 * Starts a server that listens on the loopback interface only.
 * @param folder folder of its append-only file; the same folder restores the same data
 * @throws Error if the server ends, or does not accept connections within 10 s
 */
export async function startRedis(
  folder: string,
  { port = 0, settings = [] }: { port?: number; settings?: string[] } = {},
): Promise<RedisServer> {
  const path = findRedis();
  if (path === null) throw new Error(NOT_FOUND);
  const actualPort = port === 0 ? await freePort() : port;
  const network = ["--port", String(actualPort), "--bind", "127.0.0.1", "--dir", folder];
  const persistence = ["--appendonly", "yes", "--appendfsync", "everysec", "--save", ""];
  const child = spawn(path, [...network, ...persistence, ...settings], {
    stdio: ["ignore", "pipe", "pipe"],
  });
  const ended = new Promise<void>((resolve) => child.once("close", () => resolve()));
  await new Promise<void>((resolve, reject) => {
    let output = "";
    const timer = setTimeout(() => reject(new Error(`Redis did not start: ${output}`)), START_MS);
    child.once("error", reject);
    child.once("close", () => reject(new Error(`Redis ended: ${output}`)));
    child.stdout.on("data", (data: Buffer) => {
      output += data.toString();
      if (!output.includes("eady to accept connections")) return;
      clearTimeout(timer);
      child.stdout.removeAllListeners("data").resume();
      resolve();
    });
    child.stderr.resume();
  });
  return {
    url: `redis://127.0.0.1:${actualPort}`,
    port: actualPort,
    pid: child.pid ?? 0,
    ended,
    stop: async (signal = "SIGTERM") => {
      child.kill(signal);
      await ended;
    },
  };
}
