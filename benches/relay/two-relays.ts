/**
 * What it costs that a robot's page and its reader are at different relays. Each relay has as many of both as the one
 * has in the other case: two serve twice as many robots, and what is compared is the time for one.
 */
import type { Goal } from "../core/goals.ts";
import { startTwoRelays } from "./contenders/start.ts";
import { Load } from "./load/load.ts";
import { coreShare, costEach, measureInTurn, quantileOf, timesAsMuch, typical } from "./rounds.ts";
import { printRow, type Section } from "./section.ts";

const ROBOTS = 200;
const CROWD = { contender: "corridor", scripts: 0 } as const;
const PACE = { aSecond: 30, commandsASecond: 0, seconds: 4 };
const ROUNDS = 5;

export const twoRelays: Section = {
  title: "Two relays",
  measure: async (): Promise<readonly Goal[]> => {
    const relays = await startTwoRelays();
    if (relays === null) return [goal(Number.NaN)];
    const { one, apart } = relays;
    const load = Load.start();
    try {
      const { pids } = one;
      const [together, split] = [
        await load.open({ ...CROWD, robots: ROBOTS, pages: one.pages, readers: one.readers }),
        await load.open({
          ...CROWD,
          robots: 2 * ROBOTS,
          pages: `${apart.pages},${apart.readers}`,
          readers: `${apart.readers},${apart.pages}`,
        }),
      ];
      // The second relay has done nothing yet: what it costs to compile its code is not what a robot costs.
      await load.paced({ fleet: split, pids, ...PACE });
      const rounds = await measureInTurn(
        new Map([
          ["one", () => load.paced({ fleet: together, pids, ...PACE })],
          ["apart", () => load.paced({ fleet: split, pids, ...PACE })],
        ]),
        ROUNDS,
      );
      printRow("30/s each", ["% of a core", "us of cpu each", "way p50, us", "p99, us"]);
      for (const [name, seen] of rounds) {
        printRow(name === "one" ? `${ROBOTS} robots at one` : `${2 * ROBOTS} at two, apart`, [
          typical(seen, coreShare),
          typical(seen, costEach),
          typical(seen, quantileOf("ways", 0.5)),
          typical(seen, quantileOf("ways", 0.99)),
        ]);
      }
      return [goal(timesAsMuch(rounds.get("apart") ?? [], rounds.get("one") ?? [], costEach))];
    } finally {
      await load.stop();
      await one.stop();
    }
  },
};

function goal(measured: number): Goal {
  return {
    label: "processor time of a robot with its reader at another relay, against one relay",
    measured,
    bound: { atMost: 1.3 },
    unit: "times",
  };
}
