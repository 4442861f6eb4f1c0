/** Memory of connections on which nothing happens: robots with a page and a reader each. */
import type { Goal } from "../core/goals.ts";
import type { ContenderName } from "./contenders/contender.ts";
import { start } from "./contenders/start.ts";
import { Load } from "./load/load.ts";
import { pause } from "./load/watch.ts";
import { residentKiB } from "./process-figures.ts";
import { printRow, type Section } from "./section.ts";

const NAMES: readonly ContenderName[] = ["bare", "corridor", "socket.io"];
/** What a process needs once, and what its first visitors make it compile, is not counted. */
const FIRST_ROBOTS = 100;
const FOLLOWED = { robots: 100, onlookers: 56 };
const ALONE = { robots: 1000, onlookers: 0 };
/** The garbage of their coming is collected only once it has been quiet for a while. */
const SETTLE_MS = 12_000;

export const idle: Section = {
  title: "Idle",
  measure: async (): Promise<readonly Goal[]> => {
    const figures = new Map<ContenderName, number>();
    printRow("KiB of memory", ["a connection", "a robot"]);
    for (const name of NAMES) {
      const { connection, robot } = await measureIdle(name);
      figures.set(name, connection);
      printRow(name, [connection, robot]);
    }
    return [
      {
        label: "memory of an idle connection",
        measured: figures.get("corridor") ?? Number.NaN,
        bound: { atMost: 12 },
        unit: "KiB",
      },
    ];
  },
};

/** A connection: of 100 robots that 56 look on at each. A robot: with its page and a reader. */
async function measureIdle(name: ContenderName): Promise<{ connection: number; robot: number }> {
  const running = await start(name, false);
  const [pid] = running?.pids ?? [];
  if (running === null || pid === undefined) return { connection: Number.NaN, robot: Number.NaN };
  const load = Load.start();
  const { pages, readers } = running;
  const where = { contender: name, pages, readers, scripts: 0 };
  const growth = async (crowd: { robots: number; onlookers: number }): Promise<number> => {
    const before = residentKiB(pid);
    await load.open({ ...where, ...crowd });
    await pause(SETTLE_MS);
    return residentKiB(pid) - before;
  };
  try {
    await growth({ robots: FIRST_ROBOTS, onlookers: 0 });
    const connections = FOLLOWED.robots * (2 + FOLLOWED.onlookers);
    const connection = (await growth(FOLLOWED)) / connections;
    return { connection, robot: (await growth(ALONE)) / ALONE.robots };
  } finally {
    await load.stop();
    await running.stop();
  }
}
