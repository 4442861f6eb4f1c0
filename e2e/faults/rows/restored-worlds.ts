/**
 * What scripts were told, and where the robot stands, never disagree: tabs are reloaded and crash
 * at any moment, also with their relay, and the poses of all endings are summed up.
 */
import type { CommandRecord, Order, Pose } from "@corridor/protocol";
import { Dice } from "../../../apps/relay/src/testing/faults/dice.ts";
import { RawChromium } from "../../support/devtools.ts";
import { RelayProcess } from "../../support/relay-process.ts";
import { sleep, until } from "../clock.ts";
import { RealRobot } from "../robots/real-robot.ts";
import type { Row, Terms } from "../row.ts";

const SPEEDS = ["1", "4", "16"];
const SHORT_TIMES = 28;
const LONG_TIMES = 200;
const PATIENCE_MS = 30_000;
const TURN = 11;
const MOVE = 5;
/** Rounding of sums, in cm and degrees. */
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

export const restoredWorlds: Row = {
  title: "Restored worlds",
  does: (isLong) =>
    `${timesOf(isLong) * SPEEDS.length} reloads and crashes of real tabs at ${SPEEDS.join(", ")} times the speed while scripts turn and move their robots, every third with a kill -9 of the relay`,
  run: async (terms) => {
    const lanes = await Promise.all(SPEEDS.map((speed, lane) => disturbed(terms, speed, lane)));
    const sum = (what: "reloads" | "crashes" | "relayKills" | "commands" | "cancelled") =>
      lanes.reduce((total, lane) => total + lane[what], 0);
    for (const { contradictions } of lanes) for (const each of contradictions) terms.say(each);
    return [
      {
        label: "reloads and crashes",
        measured: sum("reloads") + sum("crashes"),
        bound: { atLeast: timesOf(terms.isLong) * SPEEDS.length },
        unit: `(${sum("crashes")} crashes, ${sum("relayKills")} with the relay)`,
      },
      {
        label: "completed commands at each speed",
        measured: Math.min(...lanes.map(({ completed }) => completed)),
        bound: { atLeast: timesOf(terms.isLong) },
        unit: `(${sum("cancelled")} of ${sum("commands")} were cancelled)`,
      },
      {
        label: "endings that contradict the robot's pose",
        measured: lanes.reduce((total, { contradictions }) => total + contradictions.length, 0),
        bound: { atMost: 0 },
        unit: `of ${sum("commands")}`,
      },
    ];
  },
};

/** One robot at one speed. */
async function disturbed(terms: Terms, speed: string, lane: number): Promise<Findings> {
  const dice = new Dice(terms.seed + lane);
  const relay = await RelayProcess.start();
  terms.after(() => relay.stop());
  const browser = await RawChromium.start();
  terms.after(() => browser.close());
  const robot = await RealRobot.open(browser, relay.url);
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
      const order = orderFrom(pose, home, dice);
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
    for (let n = 0; n < timesOf(terms.isLong); n++) {
      // Mostly the robot is back by then and has ended something.
      const { commands } = findings;
      if (dice.isLucky(0.8)) await until(() => findings.commands > commands, PATIENCE_MS);
      await sleep(dice.between(50, 1_500));
      const isWithRelay = n % 3 === 2;
      if (isWithRelay) findings.relayKills += 1;
      const killed = isWithRelay ? relay.kill() : Promise.resolve();
      if (dice.isLucky(0.5)) findings.reloads += 1;
      else {
        findings.crashes += 1;
        await robot.page.crash();
      }
      await killed;
      // The service worker has the page's files, but a crash may come before it has all.
      if (isWithRelay) await relay.restart();
      await robot.page.reload();
      await robot.setSpeed(speed);
    }
  };
  const driving = drive();
  await Promise.race([disturb(), driving.then(() => Promise.reject(new Error("No pose.")))]);
  // A last ending shows that the robot stands where the others had left it.
  await sleep(2_000);
  isOver = true;
  await driving;
  return findings;
}

/** A turn, or a small move that does not lead away from home. */
function orderFrom(pose: Pose, home: Pose, dice: Dice): Order {
  if (dice.isLucky(0.6)) return { action: "turn", degrees: dice.isLucky(0.7) ? TURN : -TURN };
  const [dx, dy] = ahead(pose);
  const isAway = (pose.x - home.x) * dx + (pose.y - home.y) * dy > 0;
  return { action: "move", distance: isAway ? -MOVE : MOVE };
}

/** Unit vector of a heading: degrees clockwise from north, y grows to the south. */
function ahead({ heading }: Pose): [number, number] {
  const angle = (heading * Math.PI) / 180;
  return [Math.sin(angle), -Math.cos(angle)];
}

/** Why an ending cannot follow the one before it; null where it can. */
function contradiction(before: Pose, order: Order, record: CommandRecord): string | null {
  const { state, pose, distance } = record;
  if (pose === null || distance === null) return "an ending without pose or distance";
  if (state !== "completed" && state !== "cancelled") return "neither completed nor cancelled";
  const [dx, dy] = ahead(before);
  const turned = ((pose.heading - before.heading + 540) % 360) - 180;
  const moved = (pose.x - before.x) * dx + (pose.y - before.y) * dy;
  const aside = (pose.x - before.x) * -dy + (pose.y - before.y) * dx;
  if (Math.abs(aside) > EPSILON) return "the robot stands beside its way";
  const wishes = {
    turned: order.action === "turn" ? order.degrees : 0,
    moved: order.action === "move" ? order.distance : 0,
  };
  if (!reaches(turned, wishes.turned, state === "completed")) return `turned by ${turned}`;
  if (!reaches(moved, wishes.moved, state === "completed")) return `moved by ${moved}`;
  const isMove = order.action === "move";
  if (isMove && Math.abs(Math.abs(moved) - distance) > EPSILON) return "another distance";
  return null;
}

/** Whether something was done whole, or, where it was cancelled, up to there. */
function reaches(done: number, wished: number, isWhole: boolean): boolean {
  if (isWhole) return Math.abs(done - wished) <= EPSILON;
  return Math.abs(done) <= Math.abs(wished) + EPSILON && done * Math.sign(wished) >= -EPSILON;
}
