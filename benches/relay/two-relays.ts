/**
 * Measures the cost of a robot whose page and reader are connected to different relays, compared
 * with one relay. Two relays serve twice as many robots, so that each relay has the same number of
 * pages and readers in both cases. The goal compares the processor time per robot.
 */
import type { Goal } from "../core/goals.ts";
import { Load } from "./load/load.ts";
import { startTwoRelays } from "./peers/start-peer.ts";
import {
  coreShare,
  costPerItem,
  measureAlternately,
  medianOf,
  quantileOf,
  ratioOf,
} from "./rounds.ts";
import { printRow, type Section } from "./section.ts";

const ROBOTS = 200;
const LOAD = { peer: "corridor", scripts: 0 } as const;
const PACE = { snapshotsPerSecond: 30, commandsPerSecond: 0, seconds: 4 };
const ROUNDS = 5;

export const twoRelays: Section = {
  title: "Two relays",
  measure: async (): Promise<readonly Goal[]> => {
    const relays = await startTwoRelays();
    if (relays === null) return [goal(Number.NaN)];
    const { one, split } = relays;
    const load = Load.start();
    try {
      const { pids } = one;
      const [oneFleet, splitFleet] = [
        await load.open({ ...LOAD, robots: ROBOTS, pages: one.pages, readers: one.readers }),
        await load.open({
          ...LOAD,
          robots: 2 * ROBOTS,
          pages: `${split.pages},${split.readers}`,
          readers: `${split.readers},${split.pages}`,
        }),
      ];
      // A warm-up, because the second relay has not compiled its code yet.
      await load.paced({ fleet: splitFleet, pids, ...PACE });
      const rounds = await measureAlternately(
        new Map([
          ["one", () => load.paced({ fleet: oneFleet, pids, ...PACE })],
          ["split", () => load.paced({ fleet: splitFleet, pids, ...PACE })],
        ]),
        ROUNDS,
      );
      printRow("30/s each", ["% of a core", "us of cpu each", "p50, us", "p99, us"]);
      for (const [name, results] of rounds) {
        printRow(name === "one" ? `${ROBOTS} robots at one` : `${2 * ROBOTS} at two, split`, [
          medianOf(results, coreShare),
          medianOf(results, costPerItem),
          medianOf(results, quantileOf("latencies", 0.5)),
          medianOf(results, quantileOf("latencies", 0.99)),
        ]);
      }
      return [goal(ratioOf(rounds.get("split") ?? [], rounds.get("one") ?? [], costPerItem))];
    } finally {
      await load.stop();
      await one.stop();
    }
  },
};

function goal(measured: number): Goal {
  return {
    label: "processor time per robot with its reader at another relay, relative to one relay",
    measured,
    bound: { atMost: 1.3 },
    unit: "times",
  };
}
