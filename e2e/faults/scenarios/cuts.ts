/** Connections of pages and scripts are cut repeatedly, each independently, and recover. */
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { machineNow, sleep, waitUntil } from "../clock.ts";
import { FaultProxy } from "../net/fault-proxy.ts";
import { percentile } from "../percentile.ts";
import type { Robot } from "../robots/robot.ts";
import type { Scenario, ScenarioContext } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";
import type { Script } from "../scripts/script.ts";
import { Traffic } from "../traffic.ts";

const ROBOTS = 9;
const PER_SECOND = 3;
const SHORT_CUTS = 2_000;
const LONG_CUTS = 20_000;
/** maximum time to wait for a connection to resume; it is recorded as this time */
const GIVE_UP_MS = 20_000;

const cutsOf = (isLong: boolean): number => (isLong ? LONG_CUTS : SHORT_CUTS);

/** The network of one client, with its own faults. */
interface Network {
  proxy: FaultProxy;
  isPage: boolean;
  isResumed(since: number): boolean;
}

export const cuts: Scenario = {
  title: "Cuts",
  describe: (isLong) =>
    `The connections of ${ROBOTS} pages and their scripts are cut ${cutsOf(isLong).toLocaleString("en")} times: resets, closes, outages of up to 1 s, half-open connections, delays, slices`,
  run: async (context) => {
    const random = new SeededRandom(context.seed);
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const net = (): Promise<FaultProxy> => startNet(relay, random, context);
    const testBed = new TestBed(context);
    await testBed.register(relay.url, ROBOTS);
    const pages = await testBed.startPages();
    const networks: Network[] = [];
    const scriptNets = new Map<Robot, FaultProxy>();
    for (const [n, robot] of testBed.robots.entries()) {
      const proxy = await net();
      testBed.open(robot, pages, proxy.origin, n % 2 === 0 ? "both" : "websocket");
      networks.push({
        proxy,
        isPage: true,
        isResumed: (since) => robot.isConnected && proxy.answeredAt > since,
      });
      scriptNets.set(robot, await net());
    }
    await testBed.waitUntilConnected();
    const scripts = await testBed.connectScripts((robot) => scriptNets.get(robot)?.origin ?? "");
    for (const [n, robot] of testBed.robots.entries())
      networks.push(scriptNetwork(scripts[n], scriptNets.get(robot)));
    const traffic = new Traffic(scripts, PER_SECOND, random);

    const remaining = { cuts: cutsOf(context.isLong) };
    const resumed = (
      await Promise.all(networks.map((network) => breakRepeatedly(network, remaining, random)))
    ).flat();
    for (const { proxy } of networks) proxy.clearFaults();
    await traffic.drain(testBed.robots, relay.url);
    const compared = await testBed.compare(relay.url);
    return [
      {
        label: "cuts",
        measured: resumed.length,
        bound: { atLeast: cutsOf(context.isLong) },
        unit: "",
      },
      ...compared.goals(),
      {
        label: "from the end of a cut until the client resumes, p50",
        measured: percentile(resumed, 50),
        bound: { atMost: 3_000 },
        unit: "ms",
      },
      {
        label: "from the end of a cut until the client resumes, slowest",
        measured: Math.max(...resumed),
        bound: { atMost: 3_000 },
        unit: "ms",
      },
    ];
  },
};

async function startNet(
  relay: RelayProcess,
  random: SeededRandom,
  context: ScenarioContext,
): Promise<FaultProxy> {
  const proxy = await FaultProxy.start({ target: () => relay.port, random });
  context.onCleanup(() => proxy.close());
  return proxy;
}

function scriptNetwork(script: Script | undefined, proxy: FaultProxy | undefined): Network {
  if (script === undefined || proxy === undefined) throw new Error("a robot has no script");
  return { proxy, isPage: false, isResumed: (since) => proxy.answeredAt > since };
}

/**
 * Breaks a network until enough cuts were made. @returns ms from each recovery of the network to
 * the answer
 */
async function breakRepeatedly(
  network: Network,
  remaining: { cuts: number },
  random: SeededRandom,
): Promise<number[]> {
  const { proxy, isPage } = network;
  const resumed: number[] = [];
  while (remaining.cuts > 0) {
    await sleep(random.between(50, 700));
    proxy.isSlicing = random.chance(0.3);
    // Scripts without the library send no time, so the delay of a command adds to its start time.
    proxy.delay = random.chance(0.3) ? { min: 0, max: isPage ? 40 : 15 } : { min: 0, max: 0 };
    if (isPage && random.chance(0.1)) proxy.stall(random.between(100, 1_500));
    const cut = breakOnce(proxy, random);
    if (cut === null) continue;
    remaining.cuts -= 1;
    await sleep(cut.backAt - machineNow());
    await waitUntil(() => network.isResumed(cut.cutAt), GIVE_UP_MS);
    resumed.push(Math.max(0, machineNow() - cut.backAt));
  }
  return resumed;
}

/** @returns when the network recovers, or null if no connection was open */
function breakOnce(
  proxy: FaultProxy,
  random: SeededRandom,
): { cutAt: number; backAt: number } | null {
  if (proxy.connections === 0) return null;
  const cutAt = machineNow();
  const chance = random.next();
  if (chance < 0.7) {
    proxy.cut();
    return { cutAt, backAt: cutAt };
  }
  const ms = random.between(50, 1_000);
  if (chance < 0.85) proxy.breakFor(ms);
  else proxy.halfOpen(random.pick(["client", "relay"]), ms);
  return { cutAt, backAt: cutAt + ms };
}
