/**
 * Twenty robots with ten commands a second each on a network without faults: no command is lost,
 * and all are fast.
 */
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { callRepeatedly, sleep, waitUntil } from "../clock.ts";
import { percentile } from "../percentile.ts";
import type { Scenario } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";
import { RequestScript } from "../scripts/request-script.ts";
import type { Script } from "../scripts/script.ts";
import { ClientScript } from "../scripts/client-script.ts";
import { shortCommand } from "../commands.ts";

const ROBOTS = 20;
const PER_SECOND = 10;
const SHORT_MS = 60_000;
const LONG_MS = 600_000;
const DRAIN_MS = 60_000;

export const cleanNetwork: Scenario = {
  title: "Clean network",
  describe: (isLong) =>
    `${ROBOTS} robots receive ${PER_SECOND} commands per second each for ${length(isLong) / 1000} s, half of them by WebSocket, half by single requests`,
  run: async (context) => {
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const testBed = new TestBed(context);
    await testBed.register(relay.url, ROBOTS);
    const pages = await testBed.startPages();
    for (const robot of testBed.robots) testBed.open(robot, pages, relay.url, "both");
    await testBed.waitUntilConnected();
    const scripts: Script[] = [];
    for (const [n, robot] of testBed.robots.entries()) {
      const script =
        n % 2 === 0
          ? await ClientScript.connect(robot, relay.url, "both")
          : new RequestScript(robot, relay.url);
      context.onCleanup(() => script.close());
      scripts.push(script);
    }
    await sleep(1_000);

    // Requests are spread evenly: scripts are independent of each other.
    const total = ROBOTS * PER_SECOND;
    await callRepeatedly(total, length(context.isLong), (n) => {
      scripts[n % ROBOTS]?.post(shortCommand(Math.floor(n / ROBOTS)));
    });
    // A slow machine misses the goals for the times only: what is on its way is not lost.
    await waitUntil(() => scripts.every(({ commands }) => commands.unanswered === 0), DRAIN_MS);
    for (const robot of testBed.robots) await robot.waitUntilEnded(relay.url, DRAIN_MS);

    const compared = await testBed.compare(relay.url);
    const waits = testBed.robots.flatMap((robot, n) => {
      const starts = new Map(robot.starts.map(({ seq, at }) => [seq, at]));
      return (compared.logs.get(robot) ?? []).flatMap(({ seq, key }) => {
        const start = starts.get(seq);
        const posted = scripts[n]?.commands.postedAt(key);
        return start === undefined || posted === undefined ? [] : [start - posted];
      });
    });
    const posted = scripts.reduce((sum, { commands }) => sum + commands.posted, 0);
    return [
      {
        label: "posted commands that did not start",
        measured: posted - waits.length,
        bound: { atMost: 0 },
        unit: `of ${posted}`,
      },
      ...compared.goals(),
      {
        label: "post to start, p50",
        measured: percentile(waits, 50),
        bound: { atMost: 50 },
        unit: "ms",
      },
      {
        label: "post to start, p99",
        measured: percentile(waits, 99),
        bound: { atMost: 250 },
        unit: "ms",
      },
    ];
  },
};

function length(isLong: boolean): number {
  return isLong ? LONG_MS : SHORT_MS;
}
