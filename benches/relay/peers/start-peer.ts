/** Starts peers. A peer whose program is not installed is skipped with a message. */
import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { freePort } from "../../../scripts/free-port.ts";
import { inPath } from "../../../scripts/programs.ts";
import { findRedis, startRedis, type RedisServer } from "../../../scripts/redis-server.ts";
import type { PeerName, RunningPeer } from "./peer.ts";
import { startServer, type ServerProcess } from "./server-process.ts";

const RELAY = join(import.meta.dirname, "../../../apps/relay/src/main.ts");

/** @returns null, after printing a message, if the program is not installed */
export async function startPeer(name: PeerName, isDurable: boolean): Promise<RunningPeer | null> {
  switch (name) {
    case "bare":
      return singlePort(await startNode("bare-server.ts"));
    case "socket.io":
      return singlePort(await startNode("socket-io-server.ts"));
    case "corridor":
      return singlePort(await startRelay());
    case "mosquitto":
      return startMosquitto();
    case "redis":
      return startRedisStreams(isDurable);
  }
}

/** Starts a relay that stores its data in Redis. The second pid is that of Redis. */
export async function startRelayOnRedis(): Promise<RunningPeer | null> {
  const redis = await startRedisServer();
  if (redis === null) return null;
  const relay = await startRelay({ STORE_URL: redis.url });
  const stop = async (): Promise<void> => {
    await relay.stop();
    await redis.stop();
  };
  return { pages: relay.ready, readers: relay.ready, pids: [relay.pid, redis.pid], stop };
}

/**
 * Starts two relays that share one Redis. `one` connects pages and readers to the first relay,
 * `split` connects readers to the second relay.
 */
export async function startTwoRelays(): Promise<{ one: RunningPeer; split: RunningPeer } | null> {
  const redis = await startRedisServer();
  if (redis === null) return null;
  const environment = { STORE_URL: redis.url };
  const [first, second] = [await startRelay(environment), await startRelay(environment)];
  const stop = async (): Promise<void> => {
    await Promise.all([first.stop(), second.stop()]);
    await redis.stop();
  };
  const pids = [first.pid, second.pid];
  return {
    one: { pages: first.ready, readers: first.ready, pids, stop },
    split: { pages: first.ready, readers: second.ready, pids, stop },
  };
}

function singlePort({ ready, pid, stop }: ServerProcess): RunningPeer {
  return { pages: ready, readers: ready, pids: [pid], stop };
}

function startNode(file: string): Promise<ServerProcess> {
  return startServer({
    command: process.execPath,
    args: () => [join(import.meta.dirname, file)],
    ready: /^ready (\d+)$/,
  });
}

/**
 * Starts the product in the same way as `npm start`. It trusts one proxy, so that robots of one
 * load process can send different client addresses.
 */
function startRelay(settings: Record<string, string> = {}): Promise<ServerProcess> {
  return startServer({
    command: process.execPath,
    args: () => [...nodeOptions(), RELAY],
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

/**
 * Node.js options for profiling, such as BENCH_RELAY_OPTIONS="--cpu-prof
 * --cpu-prof-dir=/tmp/profile".
 */
function nodeOptions(): string[] {
  return (process.env["BENCH_RELAY_OPTIONS"] ?? "").split(" ").filter((option) => option !== "");
}

async function startMosquitto(): Promise<RunningPeer | null> {
  const program = [...inPath("mosquitto"), "/usr/sbin/mosquitto"].find((path) => existsSync(path));
  if (program === undefined) return skip("mosquitto", "install mosquitto");
  const port = await freePort();
  const server = await startServer({
    command: program,
    args: (folder) => {
      const file = join(folder, "mosquitto.conf");
      // QoS 1 in memory, without persistence.
      const lines = [`listener ${port} 127.0.0.1`, "allow_anonymous true", "persistence false"];
      writeFileSync(file, [...lines, "max_queued_messages 0", "set_tcp_nodelay true"].join("\n"));
      return ["-c", file];
    },
    ready: /mosquitto version \S+ running/,
    stream: "stderr",
  });
  return singlePort({ ...server, ready: String(port) });
}

async function startRedisStreams(isDurable: boolean): Promise<RunningPeer | null> {
  // As in the relay, commands are stored on disk before the answer, and snapshots are not stored.
  const settings = isDurable ? ["--appendfsync", "always"] : ["--appendonly", "no"];
  const redis = await startRedisServer([...settings, "--maxclients", "20000"]);
  if (redis === null) return null;
  const port = String(redis.port);
  return { pages: port, readers: port, pids: [redis.pid], stop: () => redis.stop() };
}

/**
 * Starts Redis with a temporary folder, which is deleted when it stops.
 * @param settings in addition to the persistence that docs/operations.md recommends
 */
async function startRedisServer(settings: string[] = []): Promise<RedisServer | null> {
  if (findRedis() === null) return skip("redis", "install redis-server");
  const folder = mkdtempSync(join(tmpdir(), "corridor-bench-"));
  const redis = await startRedis(folder, { settings });
  const stop = async (): Promise<void> => {
    await redis.stop();
    rmSync(folder, { recursive: true, force: true });
  };
  return { ...redis, stop };
}

function skip(name: string, remedy: string): null {
  console.log(`  ${name}: skipped, ${remedy}`);
  return null;
}
