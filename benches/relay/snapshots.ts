/**
 * Measures the latency of a snapshot from the page through the relay to the reader, and its cost
 * for the relay. Each robot sends 15 snapshots per second: below the relay's limit of 20 per
 * second, so that the relay forwards all of them, as the peers do.
 */
import type { Goal } from "../core/goals.ts";
import { peerNames } from "./peers/peer.ts";
import {
  costPerItem,
  forwardedShare,
  measureAlternately,
  medianOf,
  quantileOf,
  ratioOf,
} from "./rounds.ts";
import { printRow, withPeers, type Section } from "./section.ts";

const LOAD = { robots: 100, scripts: 0, isDurable: false };
const SNAPSHOTS_PER_SECOND = 15;
const SECONDS = 2;
const ROUNDS = 5;

export const snapshots: Section = {
  title: "Snapshots",
  measure: () =>
    withPeers(peerNames, LOAD, async (peers, load): Promise<readonly Goal[]> => {
      const rounds = await measureAlternately(
        new Map(
          peers.map(({ name, fleet, running: { pids } }) => {
            const pace = {
              snapshotsPerSecond: SNAPSHOTS_PER_SECOND,
              commandsPerSecond: 0,
              seconds: SECONDS,
            };
            return [name, () => load.paced({ fleet, pids, ...pace })];
          }),
        ),
        ROUNDS,
      );
      const bare = rounds.get("bare") ?? [];
      printRow(`${LOAD.robots} robots, ${SNAPSHOTS_PER_SECOND}/s each`, [
        "p50, us",
        "against bare",
        "p99, us",
        "us of cpu each",
        "against bare",
        "forwarded, %",
      ]);
      for (const [name, results] of rounds) {
        printRow(name, [
          medianOf(results, quantileOf("latencies", 0.5)),
          ratioOf(results, bare, quantileOf("latencies", 0.5)),
          medianOf(results, quantileOf("latencies", 0.99)),
          medianOf(results, costPerItem),
          ratioOf(results, bare, costPerItem),
          medianOf(results, forwardedShare),
        ]);
      }
      return [
        {
          label: "latency of a snapshot, p50, relative to bare",
          measured: ratioOf(rounds.get("corridor") ?? [], bare, quantileOf("latencies", 0.5)),
          bound: { atMost: 1.25 },
          unit: "times",
        },
        {
          label: "latency of a snapshot, p50, relative to socket.io",
          measured: ratioOf(
            rounds.get("corridor") ?? [],
            rounds.get("socket.io") ?? [],
            quantileOf("latencies", 0.5),
          ),
          bound: { atMost: 1 },
          unit: "times",
        },
      ];
    }),
};
