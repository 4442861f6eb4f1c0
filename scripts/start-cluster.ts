/**
 * `npm run start:cluster`: Redis, two relays and a balancer on this machine, to see what a cluster does.
 * Ends all of it on Ctrl+C. A relay or Redis that ends before is started again in a moment, so that it can be killed.
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
let isEnding = false;

requireRedis();
mkdirSync(folder, { recursive: true });
let redis = await startRedis(folder);
const balancer = await startBalancer([], port);
console.log(`Redis       ${redis.url}, its files in ${folder}`);
watchRedis();
process.on("SIGINT", () => void end());
process.on("SIGTERM", () => void end());
for (const name of ["A", "B"]) startRelay(name);

/** Restarts a Redis that has ended, on the same port and with the same files: the relays reconnect to it. */
function watchRedis(): void {
  console.log(`Redis       to be killed by: kill -9 ${redis.pid}`);
  void redis.ended.then(() => {
    if (isEnding) return;
    console.log(`Redis has ended and is started again in ${RESTART_MS / 1000} s`);
    setTimeout(() => void restartRedis(), RESTART_MS);
  });
}

async function restartRedis(): Promise<void> {
  if (isEnding) return;
  try {
    redis = await startRedis(folder, { port: redis.port });
  } catch (error) {
    console.error(error instanceof Error ? error.message : error);
    setTimeout(() => void restartRedis(), RESTART_MS);
    return;
  }
  watchRedis();
}

function startRelay(name: string): void {
  const settings = { PORT: "0", HOST: "127.0.0.1", STORE_URL: redis.url };
  const relay = spawn(process.execPath, [MAIN], {
    env: { ...process.env, ...settings },
    stdio: ["ignore", "pipe", "inherit"],
    // Ctrl+C in the terminal is for this script alone: it ends them in order.
    detached: true,
  });
  relays.set(name, relay);
  relay.stdout.on("data", (data: Buffer) => {
    const ready = READY.exec(data.toString());
    if (ready === null) return void process.stdout.write(data);
    ports.set(name, Number(ready[1]));
    console.log(
      `Relay ${name}     http://127.0.0.1:${ready[1]}, to be killed by: kill -9 ${relay.pid}`,
    );
    changed();
  });
  relay.once("close", () => {
    ports.delete(name);
    changed();
    if (isEnding) return;
    console.log(`Relay ${name} has ended and is started again in ${RESTART_MS / 1000} s`);
    setTimeout(() => isEnding || startRelay(name), RESTART_MS);
  });
}

function changed(): void {
  const wasReady = balancer.targets.length === 2;
  balancer.targets = [...ports.values()];
  if (balancer.targets.length < 2 || wasReady) return;
  console.log(`Corridor is ready: http://localhost:${balancer.port}`);
}

async function end(): Promise<void> {
  if (isEnding) return;
  isEnding = true;
  await balancer.close();
  await Promise.all([...relays.values()].map(endRelay));
  await redis.stop();
  process.exit(0);
}

function endRelay(relay: ChildProcess): Promise<void> {
  if (relay.exitCode !== null || relay.signalCode !== null) return Promise.resolve();
  return new Promise((resolve) => {
    relay.once("close", () => resolve());
    relay.kill("SIGTERM");
  });
}
