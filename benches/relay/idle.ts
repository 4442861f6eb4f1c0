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
const ROBOTS = 1500;
/** The garbage of their coming is collected only once it has been quiet for a while. */
const SETTLE_MS = 12_000;

export const idle: Section = {
  title: "Idle",
  measure: async (): Promise<readonly Goal[]> => {
    const figures = new Map<ContenderName, number>();
    printRow(`${2 * ROBOTS} connections`, ["KiB each"]);
    for (const name of NAMES) {
      const kib = await measureIdle(name);
      figures.set(name, kib);
      printRow(name, [kib]);
    }
    return [
      {
        words: "memory of an idle connection, its share of the robot included",
        measured: figures.get("corridor") ?? Number.NaN,
        bound: { atMost: 12 },
        unit: "KiB",
      },
    ];
  },
};

async function measureIdle(name: ContenderName): Promise<number> {
  const running = await start(name, false);
  const [pid] = running?.pids ?? [];
  if (running === null || pid === undefined) return Number.NaN;
  const load = Load.start();
  try {
    const { pages, readers } = running;
    const where = { contender: name, pages, readers, scripts: 0 };
    await load.open({ ...where, robots: FIRST_ROBOTS });
    await pause(SETTLE_MS);
    const before = residentKiB(pid);
    await load.open({ ...where, robots: ROBOTS });
    await pause(SETTLE_MS);
    return (residentKiB(pid) - before) / (2 * ROBOTS);
  } finally {
    await load.stop();
    await running.stop();
  }
}
