/**
 * Measures 500 robots with one reader each: 30 snapshots per second and robot, then the same while
 * scripts send commands, then the maximum rate of snapshots.
 */
import type { Goal } from "../core/goals.ts";
import type { LoadResult } from "./load/jobs.ts";
import type { PeerName } from "./peers/peer.ts";
import {
  coreShare,
  costPerItem,
  forwardedShare,
  measureAlternately,
  medianOf,
  quantileOf,
  rate,
  ratioOf,
} from "./rounds.ts";
import { printRow, withPeers, type Section } from "./section.ts";

const NAMES: readonly PeerName[] = ["bare", "corridor", "socket.io"];
const CROWD = { robots: 500, scripts: 50, isDurable: true };
const PACE = { snapshotsPerSecond: 30, seconds: 4 };
const COMMANDS_PER_SECOND = 100;
const FLOOD = { of: "snapshots", inFlight: 64, seconds: 2 } as const;
const ROUNDS = 5;

type Rounds = ReadonlyMap<PeerName, LoadResult[]>;

export const crowd: Section = {
  title: "Crowd",
  measure: () =>
    withPeers(NAMES, CROWD, async (peers, load) => {
      const measureRounds = async (
        measure: (fleet: number, pids: readonly number[]) => Promise<LoadResult>,
      ): Promise<Rounds> => {
        const each = peers.map(
          ({ name, fleet, running }) => [name, () => measure(fleet, running.pids)] as const,
        );
        return measureAlternately(new Map(each), ROUNDS);
      };
      const measurePaced = (commandsPerSecond: number): Promise<Rounds> =>
        measureRounds((fleet, pids) => load.paced({ fleet, pids, ...PACE, commandsPerSecond }));
      const withoutCommands = await measurePaced(0);
      const withCommands = await measurePaced(COMMANDS_PER_SECOND);
      const flood = await measureRounds((fleet, pids) => load.flood({ fleet, pids, ...FLOOD }));
      printPaced("500 robots, 30/s each", withoutCommands);
      printPaced(`and ${COMMANDS_PER_SECOND} commands/s`, withCommands);
      printFlood(flood);
      return goalsOf(withCommands, flood);
    }),
};

function printPaced(title: string, rounds: Rounds): void {
  printRow(title, [
    "% of a core",
    "us of cpu each",
    "against bare",
    "forwarded, %",
    "command p50",
    "p99, us",
  ]);
  const bare = rounds.get("bare") ?? [];
  for (const [name, results] of rounds) {
    printRow(name, [
      medianOf(results, coreShare),
      medianOf(results, costPerItem),
      ratioOf(results, bare, costPerItem),
      medianOf(results, forwardedShare),
      medianOf(results, quantileOf("answers", 0.5)),
      medianOf(results, quantileOf("answers", 0.99)),
    ]);
  }
}

function printFlood(flood: Rounds): void {
  printRow("maximum rate", ["per second", "against bare", "us of cpu each", "forwarded, %"]);
  for (const [name, results] of flood) {
    printRow(name, [
      medianOf(results, rate),
      ratioOf(results, flood.get("bare") ?? [], rate),
      medianOf(results, costPerItem),
      medianOf(results, forwardedShare),
    ]);
  }
}

function goalsOf(withCommands: Rounds, flood: Rounds): readonly Goal[] {
  const product = withCommands.get("corridor") ?? [];
  return [
    {
      label: "maximum snapshots per second, relative to bare",
      measured: ratioOf(flood.get("corridor") ?? [], flood.get("bare") ?? [], rate),
      bound: { atLeast: 0.73 },
      unit: "times",
    },
    {
      label: "500 robots with one reader each, 30 snapshots and 100 commands per second",
      measured: medianOf(product, coreShare),
      bound: { atMost: 60 },
      unit: "% of a core",
    },
    {
      label: "from a command to its started event under this load, p99",
      measured: medianOf(product, quantileOf("starts", 0.99)) / 1000,
      bound: { atMost: 12 },
      unit: "ms",
    },
  ];
}
