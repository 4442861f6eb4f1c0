/** The relay's disk is full while robots are driven, and has room again later. */
import { join } from "node:path";
import { Dice } from "../../../apps/relay/src/testing/faults/dice.ts";
import { RelayProcess } from "../../support/relay-process.ts";
import { SmallDisk } from "../../support/small-disk.ts";
import { machineNow, sleep } from "../clock.ts";
import type { Robot } from "../robots/robot.ts";
import type { Row } from "../row.ts";
import { Scene } from "../scene.ts";
import { Traffic } from "../traffic.ts";

const ROBOTS = 3;
const PER_SECOND = 3;
const DISK_MIB = 12;
const FULL_MS = 10_000;
const LOOK_MS = 50;
const PATIENCE_MS = 60_000;

export const fullDisk: Row = {
  title: "Full disk",
  does: () =>
    `a disk of ${DISK_MIB} MiB is filled for ${FULL_MS / 1000} s while ${ROBOTS} robots get commands by all ways`,
  run: async (terms) => {
    const disk = SmallDisk.mount(join(terms.folder, "disk"), DISK_MIB);
    if (disk === null) throw new Error("this machine cannot: a small disk needs Linux and root");
    terms.after(() => disk.unmount());
    const relay = await RelayProcess.start({ folder: disk.folder });
    terms.after(() => relay.stop());
    const pid = relay.pid;
    const scene = new Scene(terms);
    await scene.register(relay.url, ROBOTS);
    const pages = await scene.startPages();
    for (const robot of scene.robots) scene.open(robot, pages, relay.url, "both");
    await scene.allConnected();
    const traffic = new Traffic(
      await scene.scripts(() => relay.url),
      PER_SECOND,
      new Dice(terms.seed),
    );
    const [first] = scene.robots;
    if (first === undefined) throw new Error("no robots");

    await sleep(3_000);
    disk.fill();
    const full = await whileFull(relay, first);
    disk.freeSpace();
    const roomAt = machineNow();
    const recoveredMs = await untilTaken(relay, first, roomAt);
    await sleep(3_000);
    await traffic.settle(scene.robots, relay.url);
    const compared = await scene.compare(relay.url);
    return [
      {
        label: "answers 507 to commands while it is full",
        measured: full.refused,
        bound: { atLeast: 1 },
        unit: `of ${full.asked}`,
      },
      {
        label: "answers to commands while it is full that are neither 202 nor 507",
        measured: full.others,
        bound: { atMost: 0 },
        unit: `of ${full.asked}`,
      },
      {
        label: "health that did not answer, or readiness that was not 200, while it is full",
        measured: full.unwell,
        bound: { atMost: 0 },
        unit: `of ${full.looks}`,
      },
      {
        label: "readiness that said degraded",
        measured: full.degraded,
        bound: { atLeast: 1 },
        unit: `of ${full.looks}`,
      },
      {
        label: "from room on the disk until a command is taken and it says ready",
        measured: recoveredMs,
        bound: { atMost: 10_000 },
        unit: "ms",
      },
      {
        label: "the relay is the same process",
        measured: relay.pid === pid ? 1 : 0,
        bound: { atLeast: 1 },
        unit: "",
      },
      ...compared.goals(),
    ];
  },
};

/** Asks all the time, until the disk was full for long enough. */
async function whileFull(relay: RelayProcess, robot: Robot) {
  const found = { asked: 0, refused: 0, others: 0, looks: 0, unwell: 0, degraded: 0 };
  for (const end = machineNow() + FULL_MS; machineNow() < end;) {
    const status = await post(relay, robot);
    found.asked += 1;
    if (status === 507) found.refused += 1;
    else if (status !== 202) found.others += 1;
    const { isWell, state } = await health(relay);
    found.looks += 1;
    if (!isWell) found.unwell += 1;
    if (state === "degraded") found.degraded += 1;
    await sleep(LOOK_MS);
  }
  return found;
}

/** @returns ms since there was room again; Infinity when it took too long for anybody */
async function untilTaken(relay: RelayProcess, robot: Robot, since: number): Promise<number> {
  while (machineNow() - since < PATIENCE_MS) {
    if ((await post(relay, robot)) === 202 && (await health(relay)).state === "ready") {
      return machineNow() - since;
    }
    await sleep(LOOK_MS);
  }
  return Infinity;
}

/**
 * A command without a key of its own: whether it is taken is all that is asked. @returns the status
 */
async function post(relay: RelayProcess, robot: Robot): Promise<number> {
  const { id, driverKey } = robot.registration;
  const answer = await fetch(`${relay.url}/api/v1/robots/${id}/commands`, {
    method: "POST",
    headers: { Authorization: `Bearer ${driverKey}`, "Content-Type": "application/json" },
    body: JSON.stringify({ action: "turn", degrees: 2 }),
  });
  await answer.arrayBuffer();
  // Too fast, or too many wait: that is no matter of the disk.
  return answer.status === 429 ? 202 : answer.status;
}

async function health(relay: RelayProcess): Promise<{ isWell: boolean; state: string }> {
  const alive = await fetch(`${relay.url}/healthz`);
  await alive.arrayBuffer();
  const ready = await fetch(`${relay.url}/readyz`);
  const { status } = (await ready.json()) as { status: string };
  return { isWell: alive.ok && ready.ok, state: status };
}
