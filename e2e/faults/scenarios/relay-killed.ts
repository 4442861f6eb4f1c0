/** The relay is killed repeatedly, as by a power cut, and restarts from its files. */
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { machineNow, sleep, waitUntil } from "../clock.ts";
import type { Scenario } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";
import { Traffic } from "../traffic.ts";

const ROBOTS = 6;
const PER_SECOND = 4;
const EVERY_MS = 5_000;
const SHORT_KILLS = 12;
const LONG_KILLS = 120;

const kills = (isLong: boolean): number => (isLong ? LONG_KILLS : SHORT_KILLS);

export const relayKilled: Scenario = {
  title: "Relay killed",
  describe: (isLong) =>
    `The relay is killed (kill -9) ${kills(isLong)} times in ${(kills(isLong) * EVERY_MS) / 1000} s while ${ROBOTS} robots receive commands over all transports`,
  run: async (context) => {
    const random = new SeededRandom(context.seed);
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const testBed = new TestBed(context);
    await testBed.register(relay.url, ROBOTS);
    const pages = await testBed.startPages();
    for (const robot of testBed.robots) testBed.open(robot, pages, relay.url, "both");
    await testBed.waitUntilConnected();
    const scripts = await testBed.connectScripts(() => relay.url);
    const traffic = new Traffic(scripts, PER_SECOND, random);

    const relayMs: number[] = [];
    const allMs: number[] = [];
    for (let n = 0; n < kills(context.isLong); n++) {
      const next = machineNow() + EVERY_MS;
      await sleep(random.between(500, 1_500));
      const killedAt = machineNow();
      await relay.kill();
      const exitedAt = machineNow();
      await relay.restart();
      const answer = await fetch(`${relay.url}/readyz`);
      if (!answer.ok) throw new Error(`the relay came back with ${answer.status}`);
      relayMs.push(machineNow() - killedAt);
      await waitUntil(
        () =>
          testBed.robots.every(
            ({ isConnected, connectedAt }) => isConnected && connectedAt > killedAt,
          ),
        30_000,
      );
      // Some scripts reconnect before the request above, and get no second welcome.
      await waitUntil(
        () => scripts.every(({ lastResponseAt }) => lastResponseAt > exitedAt),
        30_000,
      );
      allMs.push(machineNow() - killedAt);
      await sleep(next - machineNow());
    }
    await traffic.drain(testBed.robots, relay.url);
    const compared = await testBed.compare(relay.url);
    return [
      ...compared.goals(),
      {
        label: "from a kill until the relay responds, slowest",
        measured: Math.max(...relayMs),
        bound: { atMost: 2_000 },
        unit: "ms",
      },
      {
        label: "from a kill until all robots and scripts are connected, slowest",
        measured: Math.max(...allMs),
        bound: { atMost: 5_000 },
        unit: "ms",
      },
    ];
  },
};
