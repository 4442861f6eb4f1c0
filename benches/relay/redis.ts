/**
 * Measures the maximum rate of full lifecycles of commands at a relay that stores its data in
 * Redis. Redis has the persistence that docs/operations.md recommends. The load is that of the
 * section "Commands": with 64 commands in flight, each one is accepted, delivered, started and
 * completed, and each of these steps is committed.
 */
import type { Goal } from "../core/goals.ts";
import { FULL_LIFECYCLE, IN_FLIGHT, measureRounds } from "./commands.ts";
import type { LoadResult } from "./load/jobs.ts";
import { Load } from "./load/load.ts";
import { startRelayOnRedis } from "./peers/start-peer.ts";
import { medianOf, quantileOf, rate } from "./rounds.ts";
import { printRow, type Section } from "./section.ts";

export const redis: Section = {
  title: "Redis",
  measure: async (): Promise<readonly Goal[]> => {
    const running = await startRelayOnRedis();
    if (running === null) return [goal(Number.NaN)];
    const load = Load.start();
    try {
      const { pages, readers } = running;
      const fleet = await load.open({ peer: "corridor", pages, readers, ...FULL_LIFECYCLE });
      const rounds = await measureRounds([{ name: "corridor", running, fleet }], load);
      const results = rounds.get("corridor") ?? [];
      const times = ["p50, us", "p99, us"];
      printRow(`${IN_FLIGHT} in flight`, ["per second", ...times, "us of relay", "us of Redis"]);
      printRow("full lifecycle", [
        medianOf(results, rate),
        medianOf(results, quantileOf("answers", 0.5)),
        medianOf(results, quantileOf("answers", 0.99)),
        medianOf(results, costOf(0)),
        medianOf(results, costOf(1)),
      ]);
      return [goal(medianOf(results, rate))];
    } finally {
      await load.stop();
      await running.stop();
    }
  },
};

/** A metric: microseconds of processor time of one process per command. */
const costOf =
  (process: number) =>
  ({ processorMs, done }: LoadResult): number =>
    ((processorMs[process] ?? Number.NaN) * 1000) / done;

function goal(measured: number): Goal {
  return {
    label: "full lifecycles per second on Redis",
    measured,
    bound: { atLeast: 500 },
    unit: "a second",
  };
}
