/**
 * `npm run start:cluster`: starts Redis, two relays and a balancer on this machine, for trying out
 * a cluster. A relay or Redis that ends is restarted after 5 s, so users can kill it to test
 * failover. Ctrl+C stops all of them.
 */
import { spawn, type ChildProcess } from "node:child_process";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { startBalancer } from "./balancer.ts";
import { requireRedis, startRedis } from "./redis-server.ts";

const MAIN = join(import.meta.dirname, "../apps/relay/src/main.ts");
const RESTART_MS = 5_000;
const READY = /Corridor is ready: \S+:(\d+)/;

const port = Number(process.env["PORT"] ?? 8080);
const folder = join(process.env["DATA_DIR"] ?? "data", "cluster");
const relays = new Map<string, ChildProcess>();
const ports = new Map<string, number>();
let isStopping = false;

requireRedis();
mkdirSync(folder, { recursive: true });
let redis = await startRedis(folder);
const balancer = await startBalancer([], port);
console.log(`Redis       ${redis.url}, data in ${folder}`);
restartRedisOnExit();
process.on("SIGINT", () => void stopCluster());
process.on("SIGTERM", () => void stopCluster());
for (const name of ["A", "B"]) startRelay(name);

/** Restarts Redis when it ends, with the same port and data, so that the relays reconnect. */
function restartRedisOnExit(): void {
  console.log(`Redis       to kill it: kill -9 ${redis.pid}`);
  void redis.ended.then(() => {
    if (isStopping) return;
    console.log(`Redis has ended and restarts in ${RESTART_MS / 1000} s`);
    setTimeout(() => void restartRedis(), RESTART_MS);
  });
}

async function restartRedis(): Promise<void> {
  if (isStopping) return;
  try {
    redis = await startRedis(folder, { port: redis.port });
  } catch (error) {
    console.error(error instanceof Error ? error.message : error);
    setTimeout(() => void restartRedis(), RESTART_MS);
    return;
  }
  restartRedisOnExit();
}

function startRelay(name: string): void {
  const settings = { PORT: "0", HOST: "127.0.0.1", STORE_URL: redis.url };
  const relay = spawn(process.execPath, [MAIN], {
    env: { ...process.env, ...settings },
    stdio: ["ignore", "pipe", "inherit"],
    // Ctrl+C in the terminal must reach this script only: it stops the processes in order.
    detached: true,
  });
  relays.set(name, relay);
  relay.stdout.on("data", (data: Buffer) => {
    const ready = READY.exec(data.toString());
    if (ready === null) return void process.stdout.write(data);
    ports.set(name, Number(ready[1]));
    console.log(`Relay ${name}     http://127.0.0.1:${ready[1]}, to kill it: kill -9 ${relay.pid}`);
    updateTargets();
  });
  relay.once("close", () => {
    ports.delete(name);
    updateTargets();
    if (isStopping) return;
    console.log(`Relay ${name} has ended and restarts in ${RESTART_MS / 1000} s`);
    setTimeout(() => isStopping || startRelay(name), RESTART_MS);
  });
}

function updateTargets(): void {
  const wasReady = balancer.targets.length === 2;
  balancer.targets = [...ports.values()];
  if (balancer.targets.length < 2 || wasReady) return;
  console.log(`Corridor is ready: http://localhost:${balancer.port}`);
}

async function stopCluster(): Promise<void> {
  if (isStopping) return;
  isStopping = true;
  await balancer.close();
  await Promise.all([...relays.values()].map(stopRelay));
  await redis.stop();
  process.exit(0);
}

function stopRelay(relay: ChildProcess): Promise<void> {
  if (relay.exitCode !== null || relay.signalCode !== null) return Promise.resolve();
  return new Promise((resolve) => {
    relay.once("close", () => resolve());
    relay.kill("SIGTERM");
  });
}
