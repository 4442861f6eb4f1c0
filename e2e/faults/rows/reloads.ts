/** Tabs are reloaded in the midst of what they do, and opened a second time. */
import { hasEnded } from "@corridor/protocol";
import { Dice } from "../../../apps/relay/src/testing/faults/dice.ts";
import { RelayProcess } from "../../support/relay-process.ts";
import { sleep, until } from "../clock.ts";
import type { Pages } from "../robots/pages.ts";
import type { Robot } from "../robots/robot.ts";
import type { Row } from "../row.ts";
import { Scene } from "../scene.ts";
import { Traffic } from "../traffic.ts";

const ROBOTS = 4;
const PER_SECOND = 4;
const SHORT_TIMES = 80;
const LONG_TIMES = 800;
const PATIENCE_MS = 20_000;

const timesOf = (isLong: boolean): number => (isLong ? LONG_TIMES : SHORT_TIMES);

/** What went wrong besides what the histories show. */
interface Findings {
  reloads: number;
  seconds: number;
  /** what was running when its tab went, by robot */
  cutShort: Map<Robot, number[]>;
  losersNotTold: number;
}

export const reloads: Row = {
  title: "Reloads",
  does: (isLong) =>
    `${timesOf(isLong)} reloads (kill -9 of the tab) and second pages of ${ROBOTS} robots that get commands all the time`,
  run: async (terms) => {
    const dice = new Dice(terms.seed);
    const relay = await RelayProcess.start();
    terms.after(() => relay.stop());
    const scene = new Scene(terms);
    await scene.register(relay.url, ROBOTS);
    const tabs = new Map<Robot, Pages>();
    const openTab = async (robot: Robot): Promise<void> => {
      const pages = await scene.startPages();
      tabs.set(robot, pages);
      scene.open(robot, pages, relay.url, "both");
      await until(() => robot.isConnected, PATIENCE_MS);
    };
    for (const robot of scene.robots) await openTab(robot);
    const traffic = new Traffic(await scene.scripts(() => relay.url), PER_SECOND, dice);

    const findings: Findings = { reloads: 0, seconds: 0, cutShort: new Map(), losersNotTold: 0 };
    const times = timesOf(terms.isLong) / ROBOTS;
    const disturb = async (robot: Robot): Promise<void> => {
      for (let n = 0; n < times; n++) {
        await sleep(dice.between(200, 900));
        const tab = tabs.get(robot);
        const page = robot.page;
        if (dice.isLucky(0.6)) {
          await tab?.kill();
          note(findings, robot, page);
          await openTab(robot);
        } else {
          await openTab(robot);
          findings.seconds += 1;
          const told = await until(() => robot.losers.has(page), PATIENCE_MS);
          if (told === Infinity) findings.losersNotTold += 1;
          await tab?.kill();
          // What it does after the relay has given the robot away, the robot has not done.
          const end = robot.takenAt;
          robot.history.left(page, (_seq, at) => at < end);
        }
      }
    };
    await Promise.all(scene.robots.map(disturb));
    await traffic.settle(scene.robots, relay.url);
    const compared = await scene.compare(relay.url);

    const ran = [...findings.cutShort].flatMap(([robot, seqs]) =>
      seqs.map((seq) => compared.logs.get(robot)?.[seq - 1]),
    );
    const notCancelled = ran.filter((record) => record?.state !== "cancelled");
    for (const record of notCancelled) {
      terms.say(`${record?.seq} ran when its tab went, and is ${record?.state}: ${record?.reason}`);
    }
    return [
      {
        label: "reloads and second pages",
        measured: findings.reloads + findings.seconds,
        bound: { atLeast: timesOf(terms.isLong) },
        unit: `(${findings.seconds} second pages)`,
      },
      ...compared.goals(),
      {
        label: "started at a tab that was reloaded, and not cancelled",
        measured: notCancelled.length,
        bound: { atMost: 0 },
        unit: `of ${ran.length}`,
      },
      {
        label: "losers that were not told (4409)",
        measured: findings.losersNotTold,
        bound: { atMost: 0 },
        unit: `of ${findings.seconds}`,
      },
    ];
  },
};

/**
 * A tab is gone: what it had begun can only be cancelled. What it had told nobody, and not kept,
 * went with it.
 */
function note(findings: Findings, robot: Robot, page: number): void {
  findings.reloads += 1;
  const { lastApplied } = robot.session;
  robot.history.left(page, (seq) => seq <= lastApplied);
  const running = robot.history.begunBy(page).filter(({ what }) => !hasEnded(what));
  const seqs = running.map(({ seq }) => seq);
  findings.cutShort.set(robot, [...(findings.cutShort.get(robot) ?? []), ...seqs]);
}
