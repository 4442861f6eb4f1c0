/** The load, in a process of its own, so that it does not take part in what it measures. Told what to do by messages. */
import type { ContenderName } from "../contenders/contender.ts";
import { openBare } from "../fleets/bare.ts";
import { openCorridor } from "../fleets/corridor.ts";
import type { OpenFleet } from "../fleets/fleet.ts";
import { openMosquitto } from "../fleets/mosquitto.ts";
import { openRedis } from "../fleets/redis.ts";
import { openSocketIo } from "../fleets/socket-io.ts";
import { driveFlood, drivePaced, type Driven } from "./drive.ts";
import type { Answer, Job, OpenJob } from "./jobs.ts";
import { Watch } from "./watch.ts";

const openers: Record<ContenderName, OpenFleet> = {
  bare: openBare,
  corridor: openCorridor,
  "socket.io": openSocketIo,
  mosquitto: openMosquitto,
  redis: openRedis,
};

const fleets: (Driven | null)[] = [];

process.on("message", (job: Job) => {
  run(job).then(
    (answer) => process.send?.(answer),
    (error: unknown) => {
      console.error(error);
      process.exit(1);
    },
  );
});
process.on("disconnect", () => process.exit(0));

async function run(job: Job): Promise<Answer> {
  if (job.kind === "open") return { fleet: fleets.push(await open(job)) - 1, seen: null };
  const driven = fleets[job.fleet] ?? null;
  if (driven === null) throw new Error("no such fleet");
  const { fleet } = job;
  if (job.kind === "paced") return { fleet, seen: await drivePaced(driven, job) };
  if (job.kind === "flood") return { fleet, seen: await driveFlood(driven, job) };
  await driven.fleet.close();
  fleets[fleet] = null;
  return { fleet, seen: null };
}

async function open({
  contender,
  robots,
  scripts,
  onlookers = 0,
  isBusy = false,
  pages,
  readers,
}: OpenJob): Promise<Driven> {
  const watch = new Watch(robots);
  const fleet = await openers[contender]({
    pages,
    readers,
    robots,
    scripts,
    onlookers,
    isBusy,
    ears: watch,
  });
  return { fleet, watch, robots, scripts };
}
