/** Measures the memory of idle connections: robots with one page and one reader each. */
import type { Goal } from "../core/goals.ts";
import { delay } from "./load/load-recorder.ts";
import { Load } from "./load/load.ts";
import type { PeerName } from "./peers/peer.ts";
import { startPeer } from "./peers/start-peer.ts";
import { residentKiB } from "./process-metrics.ts";
import { printRow, type Section } from "./section.ts";

const NAMES: readonly PeerName[] = ["bare", "corridor", "socket.io"];
/** Unmeasured robots, so that memory for startup and compiled code is not counted. */
const WARM_UP_ROBOTS = 100;
const WITH_VIEWERS = { robots: 100, viewers: 56 };
const WITHOUT_VIEWERS = { robots: 1000, viewers: 0 };
/**
 * Delay until the process has been idle long enough to collect the garbage of opening connections.
 */
const GARBAGE_COLLECTION_MS = 12_000;

export const idle: Section = {
  title: "Idle",
  measure: async (): Promise<readonly Goal[]> => {
    const connectionKiB = new Map<PeerName, number>();
    printRow("KiB of memory", ["per connection", "per robot"]);
    for (const name of NAMES) {
      const { connection, robot } = await measureIdle(name);
      connectionKiB.set(name, connection);
      printRow(name, [connection, robot]);
    }
    return [
      {
        label: "memory of an idle connection",
        measured: connectionKiB.get("corridor") ?? Number.NaN,
        bound: { atMost: 12 },
        unit: "KiB",
      },
    ];
  },
};

/**
 * @returns KiB per connection, measured with 100 robots that have 56 viewers each, and KiB per
 * robot with one page and one reader
 */
async function measureIdle(name: PeerName): Promise<{ connection: number; robot: number }> {
  const running = await startPeer(name, false);
  const [pid] = running?.pids ?? [];
  if (running === null || pid === undefined) return { connection: Number.NaN, robot: Number.NaN };
  const load = Load.start();
  const { pages, readers } = running;
  const target = { peer: name, pages, readers, scripts: 0 };
  const growth = async (size: { robots: number; viewers: number }): Promise<number> => {
    const before = residentKiB(pid);
    await load.open({ ...target, ...size });
    await delay(GARBAGE_COLLECTION_MS);
    return residentKiB(pid) - before;
  };
  try {
    await growth({ robots: WARM_UP_ROBOTS, viewers: 0 });
    const connections = WITH_VIEWERS.robots * (2 + WITH_VIEWERS.viewers);
    const connection = (await growth(WITH_VIEWERS)) / connections;
    return { connection, robot: (await growth(WITHOUT_VIEWERS)) / WITHOUT_VIEWERS.robots };
  } finally {
    await load.stop();
    await running.stop();
  }
}
