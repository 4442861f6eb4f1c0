/** The two kinds of load: at a steady pace, and as much as is taken. */
import type { Fleet } from "../fleets/fleet.ts";
import type { FloodJob, PacedJob, Seen } from "./jobs.ts";
import { pause, type Watch } from "./watch.ts";

/** Longest that a flood's last messages may take. */
const DRAIN_MS = 5_000;

/**
 * Snapshots that a robot of a flood reports before it is waited until they are taken: the product is asked
 * whether they are, and to ask after each would cost it more than a snapshot does.
 */
const AT_A_TIME = 4;

export interface Driven {
  fleet: Fleet;
  watch: Watch;
  robots: number;
  scripts: number;
}

/** Robots take turns, so that each has the same time between two snapshots, and no two come at once. */
export async function drivePaced(driven: Driven, job: PacedJob): Promise<Seen> {
  const { fleet, watch, robots, scripts } = driven;
  const began = performance.now();
  let reported = 0;
  let commanded = 0;
  const timer = setInterval(() => {
    const seconds = (performance.now() - began) / 1000;
    for (; reported < seconds * job.aSecond * robots; reported++) {
      const robot = reported % robots;
      fleet.report(robot, watch.reports(robot));
      watch.done();
    }
    for (; commanded < seconds * job.commandsASecond; commanded++) {
      const robot = commanded % scripts;
      watch.commands(robot);
      fleet.command(robot);
    }
  }, 1);
  const seen = await watch.during(job.seconds, job.pids);
  clearInterval(timer);
  await pause(100);
  return seen;
}

/** Each of the messages on their way is followed by the next robot's as soon as it has come. */
export async function driveFlood(driven: Driven, job: FloodJob): Promise<Seen> {
  const { watch, robots, scripts } = driven;
  const isOfCommands = job.of === "commands";
  const count = isOfCommands ? scripts : robots;
  const once = isOfCommands ? commander(driven) : reporter(driven);
  const each = isOfCommands ? 1 : AT_A_TIME;
  let isOver = false;
  let turn = 0;
  const lane = async (): Promise<void> => {
    while (!isOver) {
      await once(turn++ % count);
      for (let n = 0; n < each; n++) watch.done();
    }
  };
  const lanes = Array.from({ length: job.inFlight / each }, lane);
  const seen = await watch.during(job.seconds, job.pids);
  isOver = true;
  await Promise.race([Promise.all(lanes), pause(DRAIN_MS)]);
  // The next one finds robots that are as free as this one did.
  const { rest } = driven.fleet;
  if (rest !== null && isOfCommands) {
    for (let robot = 0; robot < count; robot++) await rest(robot);
  }
  return seen;
}

function commander({ fleet, watch }: Driven): (robot: number) => Promise<void> {
  const waiting = new Map<number, (() => void)[]>();
  watch.heardAnswer = (robot) => waiting.get(robot)?.shift()?.();
  return (robot) =>
    new Promise((resolve) => {
      const ofRobot = waiting.get(robot) ?? [];
      waiting.set(robot, ofRobot);
      ofRobot.push(resolve);
      watch.commands(robot);
      fleet.command(robot);
    });
}

function reporter(driven: Driven): (robot: number) => Promise<void> {
  const { watch } = driven;
  const { taken } = driven.fleet;
  if (taken !== null) {
    return async (robot) => {
      await reportSome(driven, robot);
      return taken(robot);
    };
  }
  const waiting = new Map<number, { n: number; resolve: () => void }[]>();
  watch.heardSnapshot = (robot, n) => {
    const ofRobot = waiting.get(robot) ?? [];
    while (ofRobot[0] !== undefined && ofRobot[0].n <= n) ofRobot.shift()?.resolve();
  };
  return async (robot) => {
    const n = await reportSome(driven, robot);
    return new Promise((resolve) => {
      const ofRobot = waiting.get(robot) ?? [];
      waiting.set(robot, ofRobot);
      ofRobot.push({ n, resolve });
    });
  };
}

/** Each by itself, as a page sends them. @returns the number of the last */
async function reportSome({ fleet, watch }: Driven, robot: number): Promise<number> {
  for (let left = AT_A_TIME; ; left--) {
    const n = watch.reports(robot);
    fleet.report(robot, n);
    if (left === 1) return n;
    await new Promise((resolve) => void setImmediate(resolve));
  }
}
