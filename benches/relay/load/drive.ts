/** Drives a fleet with one of two kinds of load: a steady rate, or the maximum rate. */
import type { Fleet } from "../fleets/fleet.ts";
import type { FloodJob, PacedJob, LoadResult } from "./jobs.ts";
import { delay, type LoadRecorder } from "./load-recorder.ts";

/** Maximum time to wait for the last messages of a flood. */
const MAX_DRAIN_MS = 5_000;

/**
 * Snapshots that a robot of a flood sends before it waits until they are processed. The product
 * confirms this by answering a `time` request, which costs more than a snapshot.
 */
const BATCH_SIZE = 4;

export interface DrivenFleet {
  fleet: Fleet;
  recorder: LoadRecorder;
  robots: number;
  scripts: number;
}

/** Sends snapshots and commands at a steady rate, evenly distributed over time and robots. */
export async function drivePaced(drivenFleet: DrivenFleet, job: PacedJob): Promise<LoadResult> {
  const { fleet, recorder, robots, scripts } = drivenFleet;
  const startedAt = performance.now();
  let snapshots = 0;
  let commands = 0;
  const timer = setInterval(() => {
    const seconds = (performance.now() - startedAt) / 1000;
    for (; snapshots < seconds * job.snapshotsPerSecond * robots; snapshots++) {
      const robot = snapshots % robots;
      fleet.sendSnapshot(robot, recorder.nextSnapshot(robot));
      recorder.countDone();
    }
    for (; commands < seconds * job.commandsPerSecond; commands++) {
      const robot = commands % scripts;
      recorder.recordCommand(robot);
      fleet.sendCommand(robot);
    }
  }, 1);
  const result = await recorder.record(job.seconds, job.pids);
  clearInterval(timer);
  await delay(100);
  return result;
}

/** Keeps a constant number of messages in flight: sends the next message when one is processed. */
export async function driveFlood(drivenFleet: DrivenFleet, job: FloodJob): Promise<LoadResult> {
  const { recorder, robots, scripts } = drivenFleet;
  const sendsCommands = job.of === "commands";
  const count = sendsCommands ? scripts : robots;
  const sendAndWait = sendsCommands ? commandSender(drivenFleet) : snapshotSender(drivenFleet);
  const itemsPerSend = sendsCommands ? 1 : BATCH_SIZE;
  let isOver = false;
  let next = 0;
  const sendLoop = async (): Promise<void> => {
    while (!isOver) {
      await sendAndWait(next++ % count);
      for (let n = 0; n < itemsPerSend; n++) recorder.countDone();
    }
  };
  const loops = Array.from({ length: job.inFlight / itemsPerSend }, sendLoop);
  const result = await recorder.record(job.seconds, job.pids);
  isOver = true;
  await Promise.race([Promise.all(loops), delay(MAX_DRAIN_MS)]);
  // The next flood must start with the same state of the robots.
  const { reset } = drivenFleet.fleet;
  if (reset !== null && sendsCommands) {
    for (let robot = 0; robot < count; robot++) await reset(robot);
  }
  return result;
}

function commandSender({ fleet, recorder }: DrivenFleet): (robot: number) => Promise<void> {
  const waiting = new Map<number, (() => void)[]>();
  recorder.answerObserver = (robot) => waiting.get(robot)?.shift()?.();
  return (robot) =>
    new Promise((resolve) => {
      const pending = waiting.get(robot) ?? [];
      waiting.set(robot, pending);
      pending.push(resolve);
      recorder.recordCommand(robot);
      fleet.sendCommand(robot);
    });
}

function snapshotSender(drivenFleet: DrivenFleet): (robot: number) => Promise<void> {
  const { recorder } = drivenFleet;
  const { whenProcessed } = drivenFleet.fleet;
  if (whenProcessed !== null) {
    return async (robot) => {
      await sendBatch(drivenFleet, robot);
      return whenProcessed(robot);
    };
  }
  const waiting = new Map<number, { n: number; resolve: () => void }[]>();
  recorder.snapshotObserver = (robot, n) => {
    const pending = waiting.get(robot) ?? [];
    while (pending[0] !== undefined && pending[0].n <= n) pending.shift()?.resolve();
  };
  return async (robot) => {
    const n = await sendBatch(drivenFleet, robot);
    return new Promise((resolve) => {
      const pending = waiting.get(robot) ?? [];
      waiting.set(robot, pending);
      pending.push({ n, resolve });
    });
  };
}

/** Sends a batch of snapshots, one per event-loop turn as a page does. @returns the last number */
async function sendBatch({ fleet, recorder }: DrivenFleet, robot: number): Promise<number> {
  for (let left = BATCH_SIZE; ; left--) {
    const n = recorder.nextSnapshot(robot);
    fleet.sendSnapshot(robot, n);
    if (left === 1) return n;
    await new Promise((resolve) => void setImmediate(resolve));
  }
}
