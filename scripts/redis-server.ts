/**
 * Finds the Redis or Valkey that tests and `npm run start:cluster` start, or installs one where that can
 * be done without asking; and starts one that keeps what it is given.
 */
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { freePort } from "./free-port.ts";
import { inPath, tryInstall } from "./programs.ts";

const START_MS = 10_000;
const HOW_TO_GET_IT =
  "Redis is needed. Install it (Debian, Ubuntu: `apt-get install redis-server`; macOS: `brew install redis`), or set REDIS_SERVER_PATH to a redis-server or valkey-server.";

export interface RedisServer {
  /** such as redis://127.0.0.1:6379 */
  url: string;
  port: number;
  pid: number;
  /** when it has ended, however that came about */
  ended: Promise<void>;
  /** Ends it. What it was given stays in its folder. */
  stop(signal?: "SIGTERM" | "SIGKILL"): Promise<void>;
}

/** The path of a server; null when there is none. `REDIS_SERVER_PATH` comes first. */
export function findRedis(): string | null {
  const wanted = process.env["REDIS_SERVER_PATH"] ?? "";
  const candidates = [wanted, ...["redis-server", "valkey-server"].flatMap(inPath)];
  return candidates.find((path) => path !== "" && existsSync(path)) ?? null;
}

/** Installs a server where the machine allows it; says how to get it where it does not. */
export function requireRedis(): string {
  const found = findRedis() ?? (tryInstall("redis-server") ? findRedis() : null);
  if (found === null) throw new Error(HOW_TO_GET_IT);
  return found;
}

/**
 * Starts a server on this machine alone.
 * @param folder for its files; the same folder brings back the same data
 */
export async function startRedis(
  folder: string,
  { port = 0, settings = [] }: { port?: number; settings?: string[] } = {},
): Promise<RedisServer> {
  const path = findRedis();
  if (path === null) throw new Error(HOW_TO_GET_IT);
  const chosen = port === 0 ? await freePort() : port;
  const words = ["--port", String(chosen), "--bind", "127.0.0.1", "--dir", folder];
  const durable = ["--appendonly", "yes", "--appendfsync", "everysec", "--save", ""];
  const child = spawn(path, [...words, ...durable, ...settings], {
    stdio: ["ignore", "pipe", "pipe"],
  });
  const end = new Promise<void>((resolve) => child.once("close", () => resolve()));
  await new Promise<void>((resolve, reject) => {
    let said = "";
    const timer = setTimeout(() => reject(new Error(`Redis did not start: ${said}`)), START_MS);
    child.once("error", reject);
    child.once("close", () => reject(new Error(`Redis ended: ${said}`)));
    child.stdout.on("data", (data: Buffer) => {
      said += data.toString();
      if (!said.includes("eady to accept connections")) return;
      clearTimeout(timer);
      child.stdout.removeAllListeners("data").resume();
      resolve();
    });
    child.stderr.resume();
  });
  return {
    url: `redis://127.0.0.1:${chosen}`,
    port: chosen,
    pid: child.pid ?? 0,
    ended: end,
    stop: async (signal = "SIGTERM") => {
      child.kill(signal);
      await end;
    },
  };
}
