/** Relay processes that share a real Redis, behind a load balancer. */
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { onTestFinished } from "vitest";
import { startBalancer } from "../../../scripts/balancer.ts";
import { startRedis } from "../../../scripts/redis-server.ts";
import type { RelayProcess } from "../relay-process.ts";
import { startRelayProcess } from "../test-relay-process.ts";

export interface Cluster {
  /** origin of the balancer */
  origin: string;
  /** Starts another relay, without adding it to the balancer. */
  startRelay(): Promise<RelayProcess>;
  /** Sets the relays for new connections, in turn. */
  sendTo(...relays: { port: number }[]): void;
}

export async function startCluster(): Promise<Cluster> {
  const folder = mkdtempSync(join(tmpdir(), "corridor-"));
  const redis = await startRedis(folder);
  const balancer = await startBalancer([], 0, "127.0.0.1");
  onTestFinished(async () => {
    await balancer.close();
    await redis.stop("SIGKILL");
    rmSync(folder, { recursive: true, force: true });
  });
  return {
    origin: `http://127.0.0.1:${balancer.port}`,
    startRelay: () => startRelayProcess({ environment: { STORE_URL: redis.url } }),
    sendTo: (...relays) => {
      balancer.targets = relays.map(({ port }) => port);
    },
  };
}
