/** Two relays on one Redis behind a balancer. They are killed in turn. */
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { machineNow, sleep, waitUntil } from "../clock.ts";
import { startRelayPair } from "../relay-pair.ts";
import type { Scenario } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";
import { Traffic } from "../traffic.ts";

const ROBOTS = 8;
const PER_SECOND = 4;
const EVERY_MS = 10_000;
const SHORT_KILLS = 4;
const LONG_KILLS = 60;

const killsOf = (isLong: boolean): number => (isLong ? LONG_KILLS : SHORT_KILLS);

export const twoRelays: Scenario = {
  title: "Two relays",
  describe: (isLong) =>
    `Two relays share a Redis behind a balancer while ${ROBOTS} robots receive commands over all transports. One of the relays is killed (kill -9) ${killsOf(isLong)} times, and restarts after ${EVERY_MS / 2000} s`,
  run: async (context) => {
    const random = new SeededRandom(context.seed);
    const { relays, balancer, origin } = await startRelayPair(context);

    const testBed = new TestBed(context);
    await testBed.register(origin, ROBOTS);
    const pages = await testBed.startPages();
    // A long-poll connection is bound to one relay, and this balancer has no session affinity.
    for (const robot of testBed.robots) testBed.open(robot, pages, origin, "websocket");
    await testBed.waitUntilConnected();
    const scripts = await testBed.connectScripts(() => origin, ["websocket", "requests"]);
    const traffic = new Traffic(scripts, PER_SECOND, random);

    const backMs: number[] = [];
    for (let n = 0; n < killsOf(context.isLong); n++) {
      const next = machineNow() + EVERY_MS;
      await sleep(random.between(500, 2_000));
      const [killed, other] = n % 2 === 0 ? relays : [relays[1], relays[0]];
      const killedAt = machineNow();
      await killed.kill();
      balancer.targets = [other.port];
      // Clients of the other relay are not affected.
      const isBack = (): boolean =>
        testBed.robots.every(
          ({ isConnected, disconnectedAt: lostAt, connectedAt }) =>
            isConnected && (lostAt < killedAt || connectedAt > lostAt),
        );
      await sleep(100);
      await waitUntil(isBack, 60_000);
      backMs.push(machineNow() - killedAt);
      await sleep(EVERY_MS / 2 - (machineNow() - killedAt));
      await killed.restart();
      balancer.targets = relays.map(({ port }) => port);
      await sleep(next - machineNow());
    }
    await traffic.drain(testBed.robots, origin);
    const compared = await testBed.compare(origin);
    return [
      ...compared.goals(),
      {
        label: "from a kill until all robots are connected, slowest",
        measured: Math.max(...backMs),
        bound: { atMost: 5_000 },
        unit: "ms",
      },
    ];
  },
};
