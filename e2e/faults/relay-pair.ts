/** Two relays that share a Redis behind a balancer, stopped after the scenario. */
import { startBalancer } from "../../scripts/balancer.ts";
import { requireRedis, startRedis } from "../../scripts/redis-server.ts";
import { RelayProcess } from "../../tests/support/relay-process.ts";
import type { ScenarioContext } from "./scenario.ts";

export async function startRelayPair(context: ScenarioContext) {
  requireRedis();
  const redis = await startRedis(context.folder);
  context.onCleanup(() => redis.stop("SIGKILL"));
  const environment = { STORE_URL: redis.url };
  const relays = [
    await RelayProcess.start({ environment }),
    await RelayProcess.start({ environment }),
  ] as const;
  for (const relay of relays) context.onCleanup(() => relay.stop());
  const ports = relays.map(({ port }) => port);
  const balancer = await startBalancer(ports, 0, "127.0.0.1");
  context.onCleanup(() => balancer.close());
  return { relays, balancer, origin: `http://127.0.0.1:${balancer.port}` };
}
