/** Tabs are reloaded in the middle of commands, and opened a second time. */
import { hasEnded } from "@corridor/protocol";
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { sleep, waitUntil } from "../clock.ts";
import type { Pages } from "../robots/pages.ts";
import type { Robot } from "../robots/robot.ts";
import type { Scenario } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";
import { Traffic } from "../traffic.ts";

const ROBOTS = 4;
const PER_SECOND = 4;
const SHORT_TIMES = 80;
const LONG_TIMES = 800;
const TIMEOUT_MS = 20_000;

const timesOf = (isLong: boolean): number => (isLong ? LONG_TIMES : SHORT_TIMES);

/** failures that the histories do not contain */
interface Findings {
  reloads: number;
  secondPages: number;
  /** commands that were running when their tab was killed, by robot */
  interrupted: Map<Robot, number[]>;
  unnotifiedPages: number;
}

export const reloads: Scenario = {
  title: "Reloads",
  describe: (isLong) =>
    `${ROBOTS} robots receive commands continuously while their tabs are reloaded (kill -9) or second pages open, ${timesOf(isLong)} times`,
  run: async (context) => {
    const random = new SeededRandom(context.seed);
    const relay = await RelayProcess.start();
    context.onCleanup(() => relay.stop());
    const testBed = new TestBed(context);
    await testBed.register(relay.url, ROBOTS);
    const tabs = new Map<Robot, Pages>();
    const openTab = async (robot: Robot): Promise<void> => {
      const pages = await testBed.startPages();
      tabs.set(robot, pages);
      testBed.open(robot, pages, relay.url, "both");
      await waitUntil(() => robot.isConnected, TIMEOUT_MS);
    };
    for (const robot of testBed.robots) await openTab(robot);
    const traffic = new Traffic(await testBed.connectScripts(() => relay.url), PER_SECOND, random);

    const findings: Findings = {
      reloads: 0,
      secondPages: 0,
      interrupted: new Map(),
      unnotifiedPages: 0,
    };
    const times = timesOf(context.isLong) / ROBOTS;
    const disturb = async (robot: Robot): Promise<void> => {
      for (let n = 0; n < times; n++) {
        await sleep(random.between(200, 900));
        const tab = tabs.get(robot);
        const page = robot.page;
        if (random.chance(0.6)) {
          await tab?.kill();
          recordReload(findings, robot, page);
          await openTab(robot);
        } else {
          await openTab(robot);
          findings.secondPages += 1;
          const notifiedMs = await waitUntil(() => robot.replacedPages.has(page), TIMEOUT_MS);
          if (notifiedMs === Infinity) findings.unnotifiedPages += 1;
          await tab?.kill();
          // Deeds of the old page after the relay has reassigned the robot do not count.
          const end = robot.acquiredAt;
          robot.history.left(page, (_seq, at) => at < end);
        }
      }
    };
    await Promise.all(testBed.robots.map(disturb));
    await traffic.drain(testBed.robots, relay.url);
    const compared = await testBed.compare(relay.url);

    const ran = [...findings.interrupted].flatMap(([robot, seqs]) =>
      seqs.map((seq) => compared.logs.get(robot)?.[seq - 1]),
    );
    const notCancelled = ran.filter((record) => record?.state !== "cancelled");
    for (const record of notCancelled) {
      context.log(
        `${record?.seq} was running when its tab was killed, and is ${record?.state}: ${record?.reason}`,
      );
    }
    return [
      {
        label: "reloads and second pages",
        measured: findings.reloads + findings.secondPages,
        bound: { atLeast: timesOf(context.isLong) },
        unit: `(${findings.secondPages} second pages)`,
      },
      ...compared.goals(),
      {
        label: "started in a reloaded tab and not cancelled",
        measured: notCancelled.length,
        bound: { atMost: 0 },
        unit: `of ${ran.length}`,
      },
      {
        label: "replaced pages that were not notified (4409)",
        measured: findings.unnotifiedPages,
        bound: { atMost: 0 },
        unit: `of ${findings.secondPages}`,
      },
    ];
  },
};

/**
 * Records a killed tab: its started commands can only be cancelled. What it neither reported nor
 * stored is lost.
 */
function recordReload(findings: Findings, robot: Robot, page: number): void {
  findings.reloads += 1;
  const { lastApplied } = robot.session;
  robot.history.left(page, (seq) => seq <= lastApplied);
  const running = robot.history.startedBy(page).filter(({ what }) => !hasEnded(what));
  const seqs = running.map(({ seq }) => seq);
  findings.interrupted.set(robot, [...(findings.interrupted.get(robot) ?? []), ...seqs]);
}
