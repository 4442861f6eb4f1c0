/** Relay processes that share a real Redis, behind a load balancer. */
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { onTestFinished } from "vitest";
import { startBalancer } from "../../../scripts/balancer.ts";
import { startRedis } from "../../../scripts/redis-server.ts";
import { killRelay, startRelayChild } from "./relay-child.ts";

export interface Cluster {
  /** origin of the balancer */
  origin: string;
  /** Starts another relay, without adding it to the balancer. */
  startRelay(): Promise<{ port: number; kill(): Promise<void> }>;
  /** Sets the relays for new connections, in turn. */
  sendTo(...relays: { port: number }[]): void;
}

export async function startCluster(): Promise<Cluster> {
  const folder = mkdtempSync(join(tmpdir(), "corridor-"));
  const redis = await startRedis(folder);
  const balancer = await startBalancer([], 0, "127.0.0.1");
  const kills: (() => Promise<void>)[] = [];
  onTestFinished(async () => {
    await balancer.close();
    for (const kill of kills) await kill();
    await redis.stop("SIGKILL");
    rmSync(folder, { recursive: true, force: true });
  });
  return {
    origin: `http://127.0.0.1:${balancer.port}`,
    startRelay: async () => {
      const { child, port } = await startRelayChild(folder, 0, { STORE_URL: redis.url });
      const kill = () => killRelay(child);
      kills.push(kill);
      return { port, kill };
    },
    sendTo: (...relays) => {
      balancer.targets = relays.map(({ port }) => port);
    },
  };
}
