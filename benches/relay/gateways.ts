/**
 * Measures the gateways of other protocols relative to native clients of the same relay: a velocity
 * of a ROS client until it starts, the cost of snapshots as topics of ROS, 500 robots with a ROS
 * reader each, calls of agents, commands by SOAP and those of micromouse programs.
 */
import type { Registration } from "@corridor/protocol";
import type { Goal } from "../core/goals.ts";
import { quantile } from "../core/measure.ts";
import { measureMouse, measureSoap } from "./gateway-commands.ts";
import type { LoadResult, OpenJob, PacedJob } from "./load/jobs.ts";
import { Load } from "./load/load.ts";
import type { RunningPeer } from "./peers/peer.ts";
import { startPeer } from "./peers/start-peer.ts";
import {
  costPerItem,
  forwardedShare,
  measureAlternately,
  medianOf,
  quantileOf,
  ratioOf,
} from "./rounds.ts";
import { printRow, type Section } from "./section.ts";

type Size = Pick<OpenJob, "robots" | "scripts" | "drives">;
type Pace = Pick<PacedJob, "snapshotsPerSecond" | "commandsPerSecond" | "seconds">;
/** results by name: "native" and others */
type Rounds = ReadonlyMap<string, LoadResult[]>;

const ROUNDS = 7;
const ODOM = ["/odom"];
const THREE = ["/odom", "/scan", "/tf"];

/** Three velocities a second for each script: more often than the lease, less than the limit. */
const VELOCITIES: Size & Pace = {
  robots: 20,
  scripts: 20,
  drives: true,
  snapshotsPerSecond: 15,
  commandsPerSecond: 60,
  seconds: 3,
};
const SNAPSHOTS: Size & Pace = {
  robots: 100,
  scripts: 0,
  snapshotsPerSecond: 15,
  commandsPerSecond: 0,
  seconds: 3,
};
const CROWD: Size & Pace = {
  robots: 500,
  scripts: 0,
  snapshotsPerSecond: 30,
  commandsPerSecond: 0,
  seconds: 4,
};
const CALLS = 300;

export const gateways: Section = {
  title: "Gateways",
  measure: async (): Promise<readonly Goal[]> => {
    const velocities = await measure({ native: null, ros: ODOM }, VELOCITIES);
    printRow("20 robots, velocities", ["to started, us", "p99, us"]);
    for (const [name, results] of velocities) {
      const starts = [0.5, 0.99].map((share) => medianOf(results, quantileOf("starts", share)));
      printRow(name, starts);
    }
    const snapshots = await measure({ native: null, odom: ODOM, three: THREE }, SNAPSHOTS);
    printCost("100 robots, 15/s each", snapshots);
    const crowd = await measure({ native: null, odom: ODOM }, CROWD);
    printCost("500 robots, 30/s each", crowd);
    await printCalls();
    const commands = await measureCommands();
    return [
      goal("from a velocity of a ROS client to its start, p50", 1.15, {
        rounds: velocities,
        name: "ros",
        metric: quantileOf("starts", 0.5),
      }),
      goal("processor time of a snapshot as /odom", 1.5, { rounds: snapshots, name: "odom" }),
      goal("processor time of a snapshot as /odom, /scan and /tf", 2.2, {
        rounds: snapshots,
        name: "three",
      }),
      goal("processor time of 500 robots with a ROS reader each", 1.5, {
        rounds: crowd,
        name: "odom",
      }),
      ...commands,
    ];
  },
};

/**
 * Measures one relay with native readers and with readers of ROS in turn.
 * @param readers the topics of each kind of reader; null: native
 */
async function measure(
  readers: Record<string, readonly string[] | null>,
  { robots, scripts, drives = false, ...pace }: Size & Pace,
): Promise<Rounds> {
  const relay = await startRelay();
  const load = Load.start();
  try {
    const { pages, readers: port, pids } = relay;
    const measurements = new Map<string, () => Promise<LoadResult>>();
    for (const [name, ros] of Object.entries(readers)) {
      const size = { peer: "corridor", pages, readers: port, robots, scripts, drives } as const;
      const fleet = await load.open({ ...size, ros });
      measurements.set(name, () => load.paced({ fleet, pids, ...pace }));
    }
    // A warm-up, in which V8 compiles the code.
    await measureAlternately(measurements, 1);
    return await measureAlternately(measurements, ROUNDS);
  } finally {
    await load.stop();
    await relay.stop();
  }
}

function printCost(title: string, rounds: Rounds): void {
  printRow(title, ["us of cpu each", "against native", "p50, us", "forwarded, %"]);
  for (const [name, results] of rounds) {
    printRow(name, [
      medianOf(results, costPerItem),
      ratioOf(results, rounds.get("native") ?? [], costPerItem),
      medianOf(results, quantileOf("latencies", 0.5)),
      medianOf(results, forwardedShare),
    ]);
  }
}

function goal(
  label: string,
  atMost: number,
  {
    rounds,
    name,
    metric = costPerItem,
  }: { rounds: Rounds; name: string; metric?: (result: LoadResult) => number },
): Goal {
  return {
    label: `${label}, relative to native`,
    measured: ratioOf(rounds.get(name) ?? [], rounds.get("native") ?? [], metric),
    bound: { atMost },
    unit: "times",
  };
}

async function measureCommands(): Promise<readonly Goal[]> {
  const relay = await startRelay();
  try {
    const origin = `http://127.0.0.1:${relay.pages}`;
    return [await measureSoap(origin), await measureMouse(origin)];
  } finally {
    await relay.stop();
  }
}

/** Calls of an agent one after the other, and the native request that returns the same. */
async function printCalls(): Promise<void> {
  const relay = await startRelay();
  try {
    const origin = `http://127.0.0.1:${relay.pages}`;
    const made = await fetch(`${origin}/api/v1/robots`, { method: "POST" });
    const { id, driverKey } = (await made.json()) as Registration;
    const headers = { Authorization: `Bearer ${driverKey}`, "Content-Type": "application/json" };
    const params = { name: "sense", arguments: {} };
    const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method: "tools/call", params });
    const call = { method: "POST", headers, body };
    printRow("one call at a time", ["p50, us", "p99, us"]);
    printRow("MCP sense", await times(() => fetch(`${origin}/r/${id}/mcp`, call)));
    const sensors = `${origin}/api/v1/robots/${id}/sensors`;
    printRow("GET sensors", await times(() => fetch(sensors, { headers })));
  } finally {
    await relay.stop();
  }
}

/** @returns p50 and p99 of a request, in us */
async function times(request: () => Promise<Response>): Promise<number[]> {
  const all: number[] = [];
  for (let n = 0; n < 2 * CALLS; n += 1) {
    const startedAt = performance.now();
    await (await request()).text();
    // The first half is a warm-up.
    if (n >= CALLS) all.push(performance.now() - startedAt);
  }
  return [0.5, 0.99].map((share) => quantile(all, share) * 1000);
}

async function startRelay(): Promise<RunningPeer> {
  const relay = await startPeer("corridor", true);
  if (relay === null) throw new Error("the relay did not start");
  return relay;
}
