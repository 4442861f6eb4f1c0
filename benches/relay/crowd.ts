/**
 * 500 robots, 30 snapshots a second each, each with a reader; then the same while some of the readers, which are
 * scripts, command. Then as many snapshots as are taken.
 */
import type { Goal } from "../core/goals.ts";
import type { ContenderName } from "./contenders/contender.ts";
import type { Seen } from "./load/jobs.ts";
import {
  coreShare,
  costEach,
  measureInTurn,
  passedShare,
  quantileOf,
  rate,
  timesAsMuch,
  typical,
} from "./rounds.ts";
import { printRow, withContenders, type Section } from "./section.ts";

const NAMES: readonly ContenderName[] = ["bare", "corridor", "socket.io"];
const CROWD = { robots: 500, scripts: 50, isDurable: true };
const PACE = { aSecond: 30, seconds: 4 };
const COMMANDS_A_SECOND = 100;
const FLOOD = { of: "snapshots", inFlight: 64, seconds: 2 } as const;
const ROUNDS = 5;

type Rounds = ReadonlyMap<ContenderName, Seen[]>;

export const crowd: Section = {
  title: "Crowd",
  measure: () =>
    withContenders(NAMES, CROWD, async (entered, load) => {
      const measured = async (
        measure: (fleet: number, pids: readonly number[]) => Promise<Seen>,
      ): Promise<Rounds> => {
        const each = entered.map(
          ({ name, fleet, running }) => [name, () => measure(fleet, running.pids)] as const,
        );
        return measureInTurn(new Map(each), ROUNDS);
      };
      const paced = (commandsASecond: number): Promise<Rounds> =>
        measured((fleet, pids) => load.paced({ fleet, pids, ...PACE, commandsASecond }));
      const alone = await paced(0);
      const commanded = await paced(COMMANDS_A_SECOND);
      const flood = await measured((fleet, pids) => load.flood({ fleet, pids, ...FLOOD }));
      printPaced("500 robots, 30/s each", alone);
      printPaced(`and ${COMMANDS_A_SECOND} commands a second`, commanded);
      printFlood(flood);
      return judged(alone, commanded, flood);
    }),
};

function printPaced(title: string, paced: Rounds): void {
  printRow(title, [
    "% of a core",
    "us of cpu each",
    "against bare",
    "passed on, %",
    "command p50",
    "p99, us",
  ]);
  const bare = paced.get("bare") ?? [];
  for (const [name, seen] of paced) {
    printRow(name, [
      typical(seen, coreShare),
      typical(seen, costEach),
      timesAsMuch(seen, bare, costEach),
      typical(seen, passedShare),
      typical(seen, quantileOf("answers", 0.5)),
      typical(seen, quantileOf("answers", 0.99)),
    ]);
  }
}

function printFlood(flood: Rounds): void {
  printRow("as many as are taken", ["a second", "against bare", "us of cpu each", "passed on, %"]);
  for (const [name, seen] of flood) {
    printRow(name, [
      typical(seen, rate),
      timesAsMuch(seen, flood.get("bare") ?? [], rate),
      typical(seen, costEach),
      typical(seen, passedShare),
    ]);
  }
}

function judged(alone: Rounds, commanded: Rounds, flood: Rounds): readonly Goal[] {
  const product = commanded.get("corridor") ?? [];
  return [
    {
      label: "snapshots that a core takes, against the bare forwarder, at 30/s of each robot",
      measured: 1 / timesAsMuch(alone.get("corridor") ?? [], alone.get("bare") ?? [], costEach),
      bound: { atLeast: 0.75 },
      unit: "times",
    },
    {
      label: "snapshots a second, as many as are taken, against the bare forwarder",
      measured: timesAsMuch(flood.get("corridor") ?? [], flood.get("bare") ?? [], rate),
      bound: { atLeast: 0.75 },
      unit: "times",
    },
    {
      label: "500 robots with a reader each, 30 snapshots a second",
      measured: typical(product, coreShare),
      bound: { atMost: 60 },
      unit: "% of a core",
    },
    {
      label: "from a command to the news that it has begun, there, p99",
      measured: typical(product, quantileOf("beginnings", 0.99)) / 1000,
      bound: { atMost: 10 },
      unit: "ms",
    },
  ];
}
