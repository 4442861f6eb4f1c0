/** Starts contenders. One whose program is not on this machine says how to get it. */
import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { freePort } from "../../../scripts/free-port.ts";
import { inPath } from "../../../scripts/programs.ts";
import { findRedis, startRedis } from "../../../scripts/redis-server.ts";
import type { ContenderName, Running } from "./contender.ts";
import { startServer, type ServerProcess } from "./server-process.ts";

const RELAY = join(import.meta.dirname, "../../../apps/relay/src/main.ts");

/** @returns null and says so when the program is missing */
export async function start(name: ContenderName, isDurable: boolean): Promise<Running | null> {
  switch (name) {
    case "bare":
      return one(await startNode("bare-server.ts"));
    case "socket.io":
      return one(await startNode("socket-io-server.ts"));
    case "corridor":
      return one(await startRelay());
    case "mosquitto":
      return startMosquitto();
    case "redis":
      return startStreams(isDurable);
  }
}

/** Two relays that share one Redis; `one` has all at the first, `apart` each reader at the second. */
export async function startTwoRelays(): Promise<{ one: Running; apart: Running } | null> {
  const folder = mkdtempSync(join(tmpdir(), "corridor-bench-"));
  if (findRedis() === null) return missing("redis", "install redis-server");
  const redis = await startRedis(folder);
  const environment = { STORE_URL: redis.url };
  const [first, second] = [await startRelay(environment), await startRelay(environment)];
  const stop = async (): Promise<void> => {
    await Promise.all([first.stop(), second.stop()]);
    await redis.stop();
    rmSync(folder, { recursive: true, force: true });
  };
  const pids = [first.pid, second.pid];
  return {
    one: { pages: first.ready, readers: first.ready, pids, stop },
    apart: { pages: first.ready, readers: second.ready, pids, stop },
  };
}

function one({ ready, pid, stop }: ServerProcess): Running {
  return { pages: ready, readers: ready, pids: [pid], stop };
}

function startNode(file: string): Promise<ServerProcess> {
  return startServer({
    command: process.execPath,
    words: () => [join(import.meta.dirname, file)],
    ready: /^ready (\d+)$/,
  });
}

/** The product, as `npm start` runs it. Load comes from one machine, so each robot names an address of its own. */
function startRelay(settings: Record<string, string> = {}): Promise<ServerProcess> {
  return startServer({
    command: process.execPath,
    words: () => [...relayOptions(), RELAY],
    environment: (folder) => ({
      HOST: "127.0.0.1",
      PORT: "0",
      DATA_DIR: folder,
      TRUSTED_PROXIES: "1",
      ...settings,
    }),
    ready: /^Corridor is ready: \S+:(\d+)$/,
  });
}

/** For finding out where the time goes: BENCH_RELAY_OPTIONS="--cpu-prof --cpu-prof-dir=/tmp/profile". */
function relayOptions(): string[] {
  return (process.env["BENCH_RELAY_OPTIONS"] ?? "").split(" ").filter((word) => word !== "");
}

async function startMosquitto(): Promise<Running | null> {
  const program = [...inPath("mosquitto"), "/usr/sbin/mosquitto"].find((path) => existsSync(path));
  if (program === undefined) return missing("mosquitto", "install mosquitto");
  const port = await freePort();
  const server = await startServer({
    command: program,
    words: (folder) => {
      const file = join(folder, "mosquitto.conf");
      // No more than it delivers anyway: QoS 1 in memory, nothing on disk.
      const lines = [`listener ${port} 127.0.0.1`, "allow_anonymous true", "persistence false"];
      writeFileSync(file, [...lines, "max_queued_messages 0", "set_tcp_nodelay true"].join("\n"));
      return ["-c", file];
    },
    ready: /mosquitto version \S+ running/,
    from: "stderr",
  });
  return one({ ...server, ready: String(port) });
}

async function startStreams(isDurable: boolean): Promise<Running | null> {
  if (findRedis() === null) return missing("redis", "install redis-server");
  const folder = mkdtempSync(join(tmpdir(), "corridor-bench-"));
  // Commands are answered after they are on disk, as the relay does it; snapshots need no disk.
  const settings = isDurable ? ["--appendfsync", "always"] : ["--appendonly", "no"];
  const redis = await startRedis(folder, { settings: [...settings, "--maxclients", "20000"] });
  return {
    pages: String(redis.port),
    readers: String(redis.port),
    pids: [redis.pid],
    stop: async () => {
      await redis.stop();
      rmSync(folder, { recursive: true, force: true });
    },
  };
}

function missing(name: string, remedy: string): null {
  console.log(`  ${name}: not measured, ${remedy}`);
  return null;
}
