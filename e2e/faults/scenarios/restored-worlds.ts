/**
 * Reported endings always agree with the robot's pose. Tabs are reloaded and crash at any moment,
 * also together with their relay, and the poses of all endings are added up.
 */
import type { CommandRecord, Order, Pose } from "@corridor/protocol";
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { RawChromium } from "../../support/devtools.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { sleep, waitUntil } from "../clock.ts";
import { BrowserRobot } from "../robots/browser-robot.ts";
import type { Scenario, ScenarioContext } from "../scenario.ts";

const SPEEDS = ["1", "4", "16"];
const SHORT_TIMES = 28;
const LONG_TIMES = 200;
const TIMEOUT_MS = 30_000;
const TURN = 11;
const MOVE = 5;
/** tolerance of sums, in cm and degrees */
const EPSILON = 0.01;

const timesOf = (isLong: boolean): number => (isLong ? LONG_TIMES : SHORT_TIMES);

interface Findings {
  reloads: number;
  crashes: number;
  relayKills: number;
  commands: number;
  completed: number;
  cancelled: number;
  contradictions: string[];
}

export const restoredWorlds: Scenario = {
  title: "Restored worlds",
  describe: (isLong) =>
    `Real tabs are reloaded or crash ${timesOf(isLong) * SPEEDS.length} times at ${SPEEDS.join(", ")} times the speed while scripts turn and move their robots. Every third time, the relay is killed (kill -9)`,
  run: async (context) => {
    const results = await Promise.all(
      SPEEDS.map((speed, result) => disturbed(context, speed, result)),
    );
    const sum = (what: "reloads" | "crashes" | "relayKills" | "commands" | "cancelled") =>
      results.reduce((total, result) => total + result[what], 0);
    for (const { contradictions } of results) for (const each of contradictions) context.log(each);
    return [
      {
        label: "reloads and crashes",
        measured: sum("reloads") + sum("crashes"),
        bound: { atLeast: timesOf(context.isLong) * SPEEDS.length },
        unit: `(${sum("crashes")} crashes, ${sum("relayKills")} with the relay)`,
      },
      {
        label: "completed commands at each speed",
        measured: Math.min(...results.map(({ completed }) => completed)),
        bound: { atLeast: timesOf(context.isLong) },
        unit: `(${sum("cancelled")} of ${sum("commands")} were cancelled)`,
      },
      {
        label: "endings that contradict the robot's pose",
        measured: results.reduce((total, { contradictions }) => total + contradictions.length, 0),
        bound: { atMost: 0 },
        unit: `of ${sum("commands")}`,
      },
    ];
  },
};

/** Runs one robot at one speed. */
async function disturbed(
  context: ScenarioContext,
  speed: string,
  result: number,
): Promise<Findings> {
  const random = new SeededRandom(context.seed + result);
  const relay = await RelayProcess.start();
  context.onCleanup(() => relay.stop());
  const browser = await RawChromium.start();
  context.onCleanup(() => browser.close());
  const robot = await BrowserRobot.open(browser, relay.url);
  await robot.setSpeed(speed);
  const findings: Findings = {
    reloads: 0,
    crashes: 0,
    relayKills: 0,
    commands: 0,
    completed: 0,
    cancelled: 0,
    contradictions: [],
  };

  let isOver = false;
  const drive = async (): Promise<void> => {
    let pose = (await robot.run({ action: "turn", degrees: TURN })).pose;
    const home = pose;
    while (!isOver && pose !== null && home !== null) {
      const order = orderFrom(pose, home, random);
      const record = await robot.run(order);
      findings.commands += 1;
      if (record.state === "completed") findings.completed += 1;
      else findings.cancelled += 1;
      const wrong = contradiction(pose, order, record);
      if (wrong !== null) {
        findings.contradictions.push(
          `at ${speed}x: ${wrong}: ${JSON.stringify({ before: pose, order, record })}`,
        );
      }
      pose = record.pose;
    }
  };
  const disturb = async (): Promise<void> => {
    for (let n = 0; n < timesOf(context.isLong); n++) {
      // Usually, the robot has reconnected and ended a command by then.
      const { commands } = findings;
      if (random.chance(0.8)) await waitUntil(() => findings.commands > commands, TIMEOUT_MS);
      await sleep(random.between(50, 1_500));
      const isWithRelay = n % 3 === 2;
      if (isWithRelay) findings.relayKills += 1;
      const killed = isWithRelay ? relay.kill() : Promise.resolve();
      if (random.chance(0.5)) findings.reloads += 1;
      else {
        findings.crashes += 1;
        await robot.page.crash();
      }
      await killed;
      // The service worker caches the page's files, but a crash may interrupt the caching.
      if (isWithRelay) await relay.restart();
      await robot.page.reload();
      await robot.setSpeed(speed);
    }
  };
  const driving = drive();
  await Promise.race([disturb(), driving.then(() => Promise.reject(new Error("No pose.")))]);
  // One more command shows that the robot is where the earlier endings left it.
  await sleep(2_000);
  isOver = true;
  await driving;
  return findings;
}

/** A turn, or a small move that does not lead away from the start. */
function orderFrom(pose: Pose, home: Pose, random: SeededRandom): Order {
  if (random.chance(0.6)) return { action: "turn", degrees: random.chance(0.7) ? TURN : -TURN };
  const [dx, dy] = ahead(pose);
  const leadsAway = (pose.x - home.x) * dx + (pose.y - home.y) * dy > 0;
  return { action: "move", distance: leadsAway ? -MOVE : MOVE };
}

/** unit vector of a heading: degrees clockwise from north, y grows to the south */
function ahead({ heading }: Pose): [number, number] {
  const angle = (heading * Math.PI) / 180;
  return [Math.sin(angle), -Math.cos(angle)];
}

/** Why an ending contradicts the one before it, or null if it does not. */
function contradiction(before: Pose, order: Order, record: CommandRecord): string | null {
  const { state, pose, distance } = record;
  if (pose === null || distance === null) return "an ending without pose or distance";
  if (state !== "completed" && state !== "cancelled") return "neither completed nor cancelled";
  const [dx, dy] = ahead(before);
  const turned = ((pose.heading - before.heading + 540) % 360) - 180;
  const moved = (pose.x - before.x) * dx + (pose.y - before.y) * dy;
  const aside = (pose.x - before.x) * -dy + (pose.y - before.y) * dx;
  if (Math.abs(aside) > EPSILON) return "the robot is beside its path";
  const requested = {
    turned: order.action === "turn" ? order.degrees : 0,
    moved: order.action === "move" ? order.distance : 0,
  };
  if (!reaches(turned, requested.turned, state === "completed")) return `turned by ${turned}`;
  if (!reaches(moved, requested.moved, state === "completed")) return `moved by ${moved}`;
  const isMove = order.action === "move";
  if (isMove && Math.abs(Math.abs(moved) - distance) > EPSILON) return "another distance";
  return null;
}

/** Whether a distance was covered fully, or at most partly when cancelled. */
function reaches(covered: number, target: number, isComplete: boolean): boolean {
  if (isComplete) return Math.abs(covered - target) <= EPSILON;
  return Math.abs(covered) <= Math.abs(target) + EPSILON && covered * Math.sign(target) >= -EPSILON;
}
