/**
 * Measures the maximum rate of commands with 64 in flight. The goal is for answered commands: the
 * product answers when a command is stored on disk, and the robots are busy, so that commands wait
 * in the queue. With the peers, a command travels to the page and its answer back. A second table
 * measures the full lifecycle: the product also delivers each command to the page, which starts and
 * ends it, and stores both on disk.
 */
import type { Goal } from "../core/goals.ts";
import type { LoadResult } from "./load/jobs.ts";
import type { Load } from "./load/load.ts";
import { peerNames, type PeerName } from "./peers/peer.ts";
import { costPerItem, measureAlternately, medianOf, quantileOf, rate, ratioOf } from "./rounds.ts";
import { printRow, withPeers, type ConnectedPeer, type LoadSize, type Section } from "./section.ts";
import { waitUntilIdle } from "./wait-until-idle.ts";

/**
 * The rate limit is 20 commands per second and key, so many scripts are needed to saturate the
 * relay.
 */
export const FULL_LIFECYCLE = { robots: 400, scripts: 400 };
/**
 * The page of a busy robot holds the maximum number of commands, so that further commands wait in
 * the queue of the relay. The limit is 64 per robot. A round must not reach it, because a rejection
 * aborts the benchmark.
 */
const ANSWER_ONLY = { robots: 1500, scripts: 1500, isBusy: true };
export const IN_FLIGHT = 64;
const SECONDS = 2;
/** Unmeasured rounds, in which V8 compiles the code; about 100,000 commands. */
const WARM_UP_ROUNDS = 4;
const ROUNDS = 7;

export const commands: Section = {
  title: "Commands",
  measure: async (): Promise<readonly Goal[]> => {
    const header = ["per second", "against bare", "p50, us", "p99, us", "us of cpu each"];
    printRow(`${IN_FLIGHT} in flight`, header);
    const answered = await measureFlood(["bare", "corridor", "mosquitto"], ANSWER_ONLY);
    printRow("full lifecycle", header);
    const lifecycles = await measureFlood(peerNames, FULL_LIFECYCLE);
    const product = answered.get("corridor") ?? [];
    const mosquitto = answered.get("mosquitto") ?? [];
    const goals: Goal[] = [
      {
        label: "commands answered after their commit, relative to bare round trips",
        measured: ratioOf(product, answered.get("bare") ?? [], rate),
        bound: { atLeast: 0.4 },
        unit: "times",
      },
      {
        label: "full lifecycles per second and core",
        measured: 1_000_000 / medianOf(lifecycles.get("corridor") ?? [], costPerItem),
        bound: { atLeast: 3_000 },
        unit: "a second",
      },
    ];
    // It may not be installed.
    if (mosquitto.length > 0) {
      goals.push({
        label: "commands answered after their commit, relative to round trips of mosquitto",
        measured: ratioOf(product, mosquitto, rate),
        bound: { atLeast: 1 },
        unit: "times",
      });
    }
    return goals;
  },
};

/** Prints a row for each peer. @returns the results of each round */
function measureFlood(
  names: readonly PeerName[],
  size: LoadSize,
): Promise<ReadonlyMap<PeerName, LoadResult[]>> {
  return withPeers(names, { ...size, isDurable: true }, async (peers, load) => {
    const rounds = await measureRounds(peers, load);
    const bare = rounds.get("bare") ?? [];
    for (const [name, results] of rounds) {
      printRow(name, [
        medianOf(results, rate),
        ratioOf(results, bare, rate),
        medianOf(results, quantileOf("answers", 0.5)),
        medianOf(results, quantileOf("answers", 0.99)),
        medianOf(results, costPerItem),
      ]);
    }
    return rounds;
  });
}

/** Floods each peer with commands in every round. @returns the results of each round */
export async function measureRounds(
  peers: readonly ConnectedPeer[],
  load: Load,
): Promise<ReadonlyMap<PeerName, LoadResult[]>> {
  const job = { of: "commands", inFlight: IN_FLIGHT, seconds: SECONDS } as const;
  const all = peers.flatMap(({ running }) => running.pids);
  const measurements = new Map(
    peers.map(({ name, fleet, running: { pids } }) => [
      name,
      async () => {
        await waitUntilIdle(all);
        return load.flood({ fleet, pids, ...job });
      },
    ]),
  );
  // The compilation of new code is not part of the cost of a command.
  await measureAlternately(measurements, WARM_UP_ROUNDS);
  return measureAlternately(measurements, ROUNDS);
}
