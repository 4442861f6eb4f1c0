/** The load process, separate from the measured processes. Receives jobs as messages. */
import { openBare } from "../fleets/bare.ts";
import { openCorridor } from "../fleets/corridor.ts";
import type { OpenFleet } from "../fleets/fleet.ts";
import { openMosquitto } from "../fleets/mosquitto.ts";
import { openRedis } from "../fleets/redis.ts";
import { openSocketIo } from "../fleets/socket-io.ts";
import type { PeerName } from "../peers/peer.ts";
import { driveFlood, drivePaced, type DrivenFleet } from "./drive.ts";
import type { Job, LoadReply, OpenJob } from "./jobs.ts";
import { LoadRecorder } from "./load-recorder.ts";

const openers: Record<PeerName, OpenFleet> = {
  bare: openBare,
  corridor: openCorridor,
  "socket.io": openSocketIo,
  mosquitto: openMosquitto,
  redis: openRedis,
};

const fleets: (DrivenFleet | null)[] = [];

process.on("message", (job: Job) => {
  run(job).then(
    (reply) => process.send?.(reply),
    (error: unknown) => {
      console.error(error);
      process.exit(1);
    },
  );
});
process.on("disconnect", () => process.exit(0));

async function run(job: Job): Promise<LoadReply> {
  if (job.kind === "open") return { fleet: fleets.push(await open(job)) - 1, result: null };
  const drivenFleet = fleets[job.fleet] ?? null;
  if (drivenFleet === null) throw new Error(`no fleet ${job.fleet}`);
  const { fleet } = job;
  if (job.kind === "paced") return { fleet, result: await drivePaced(drivenFleet, job) };
  if (job.kind === "flood") return { fleet, result: await driveFlood(drivenFleet, job) };
  await drivenFleet.fleet.close();
  fleets[fleet] = null;
  return { fleet, result: null };
}

async function open({
  peer,
  robots,
  scripts,
  viewers = 0,
  isBusy = false,
  ros = null,
  drives = false,
  pages,
  readers,
}: OpenJob): Promise<DrivenFleet> {
  const recorder = new LoadRecorder(robots);
  const fleet = await openers[peer]({
    pages,
    readers,
    robots,
    scripts,
    viewers,
    isBusy,
    ros,
    drives,
    listener: recorder,
  });
  return { fleet, recorder, robots, scripts };
}
