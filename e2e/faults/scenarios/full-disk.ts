/** The relay's disk is full while scripts drive robots, and later has space again. */
import { join } from "node:path";
import { SeededRandom } from "../../../apps/relay/src/testing/faults/seeded-random.ts";
import { RelayProcess } from "../../../tests/support/relay-process.ts";
import { SmallDisk } from "../../../tests/support/small-disk.ts";
import { machineNow, sleep } from "../clock.ts";
import type { Robot } from "../robots/robot.ts";
import type { Scenario } from "../scenario.ts";
import { TestBed } from "../test-bed.ts";
import { Traffic } from "../traffic.ts";

const ROBOTS = 3;
const PER_SECOND = 3;
const DISK_MIB = 12;
const FULL_MS = 10_000;
const POLL_MS = 50;
const TIMEOUT_MS = 60_000;

export const fullDisk: Scenario = {
  title: "Full disk",
  describe: () =>
    `A disk of ${DISK_MIB} MiB is full for ${FULL_MS / 1000} s while ${ROBOTS} robots receive commands over all transports`,
  run: async (context) => {
    const disk = SmallDisk.mount(join(context.folder, "disk"), DISK_MIB);
    if (disk === null)
      throw new Error("not supported on this machine: a small disk needs Linux and root");
    context.onCleanup(() => disk.unmount());
    const relay = await RelayProcess.start({ folder: disk.folder });
    context.onCleanup(() => relay.stop());
    const pid = relay.pid;
    const testBed = new TestBed(context);
    await testBed.register(relay.url, ROBOTS);
    const pages = await testBed.startPages();
    for (const robot of testBed.robots) testBed.open(robot, pages, relay.url, "both");
    await testBed.waitUntilConnected();
    const traffic = new Traffic(
      await testBed.connectScripts(() => relay.url),
      PER_SECOND,
      new SeededRandom(context.seed),
    );
    const [first] = testBed.robots;
    if (first === undefined) throw new Error("no robots");

    await sleep(3_000);
    disk.fill();
    const full = await whileFull(relay, first);
    disk.freeSpace();
    const freedAt = machineNow();
    const recoveredMs = await untilAccepted(relay, first, freedAt);
    await sleep(3_000);
    await traffic.drain(testBed.robots, relay.url);
    const compared = await testBed.compare(relay.url);
    return [
      {
        label: "507 responses to commands while the disk is full",
        measured: full.refused,
        bound: { atLeast: 1 },
        unit: `of ${full.posted}`,
      },
      {
        label: "responses to commands other than 202 and 507 while the disk is full",
        measured: full.others,
        bound: { atMost: 0 },
        unit: `of ${full.posted}`,
      },
      {
        label: "failed health or readiness checks while the disk is full",
        measured: full.unhealthy,
        bound: { atMost: 0 },
        unit: `of ${full.checks}`,
      },
      {
        label: "readiness checks that reported degraded",
        measured: full.degraded,
        bound: { atLeast: 1 },
        unit: `of ${full.checks}`,
      },
      {
        label: "from free space until a command is accepted and the relay is ready",
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

/** Sends commands and health checks until the disk was full for long enough. */
async function whileFull(relay: RelayProcess, robot: Robot) {
  const found = { posted: 0, refused: 0, others: 0, checks: 0, unhealthy: 0, degraded: 0 };
  for (const end = machineNow() + FULL_MS; machineNow() < end;) {
    const status = await post(relay, robot);
    found.posted += 1;
    if (status === 507) found.refused += 1;
    else if (status !== 202) found.others += 1;
    const { isHealthy, state } = await health(relay);
    found.checks += 1;
    if (!isHealthy) found.unhealthy += 1;
    if (state === "degraded") found.degraded += 1;
    await sleep(POLL_MS);
  }
  return found;
}

/** @returns ms from free space to recovery, or Infinity after the timeout */
async function untilAccepted(relay: RelayProcess, robot: Robot, since: number): Promise<number> {
  while (machineNow() - since < TIMEOUT_MS) {
    if ((await post(relay, robot)) === 202 && (await health(relay)).state === "ready") {
      return machineNow() - since;
    }
    await sleep(POLL_MS);
  }
  return Infinity;
}

/** Sends a command without an idempotency key. @returns the status */
async function post(relay: RelayProcess, robot: Robot): Promise<number> {
  const { id, driverKey } = robot.registration;
  const answer = await fetch(`${relay.url}/api/v1/robots/${id}/commands`, {
    method: "POST",
    headers: { Authorization: `Bearer ${driverKey}`, "Content-Type": "application/json" },
    body: JSON.stringify({ action: "turn", degrees: 2 }),
  });
  await answer.arrayBuffer();
  // Rate limits and full queues are unrelated to the disk.
  return answer.status === 429 ? 202 : answer.status;
}

async function health(relay: RelayProcess): Promise<{ isHealthy: boolean; state: string }> {
  const alive = await fetch(`${relay.url}/healthz`);
  await alive.arrayBuffer();
  const ready = await fetch(`${relay.url}/readyz`);
  const { status } = (await ready.json()) as { status: string };
  return { isHealthy: alive.ok && ready.ok, state: status };
}
