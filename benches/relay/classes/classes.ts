/**
 * Measures 25 classes of 40 students with one dashboard each: tiles, pauses, and 200 students who
 * join from one address at once. The cost of a tile is compared with that of a snapshot at the same
 * number of messages per second. A relay on Redis stores progress records, of which a class sends 8
 * per second.
 */
import { fork } from "node:child_process";
import { once } from "node:events";
import { join } from "node:path";
import type { Goal } from "../../core/goals.ts";
import { median, quantile } from "../../core/measure.ts";
import { ask } from "../load/ask.ts";
import { Load } from "../load/load.ts";
import { delay } from "../load/load-recorder.ts";
import { startPeer, startRelayOnRedis } from "../peers/start-peer.ts";
import { processorMs } from "../process-metrics.ts";
import { costPerItem } from "../rounds.ts";
import { printRow, type Section } from "../section.ts";
import type { ClassesJob, ClassesResult } from "./jobs.ts";

const LESSONS = { classes: 25, students: 40, tilesPerSecond: 2, seconds: 10 };
const CLASSES = { ...LESSONS, recordsPerSecond: 0, joins: 200, longPollPauses: 25 };
const RECORDS_PER_CLASS = 8;
/**
 * The records of 100 classes, sent by 25: with few records per second, waking up for each of them
 * costs Redis more than the record. Tiles do not reach Redis.
 */
const ON_REDIS = {
  ...LESSONS,
  tilesPerSecond: 0,
  recordsPerSecond: 4 * RECORDS_PER_CLASS,
  joins: 0,
  longPollPauses: 0,
};
/** As many snapshots per second as tiles. */
const SNAPSHOTS = { snapshotsPerSecond: 20, commandsPerSecond: 0, seconds: 10 };
const ROBOTS = (CLASSES.classes * CLASSES.students * CLASSES.tilesPerSecond) / 20;
const ROUNDS = 3;

export const classes: Section = {
  title: "Classes",
  measure: async (): Promise<readonly Goal[]> => {
    const rounds: { result: ClassesResult; snapshot: number }[] = [];
    for (let round = 0; round < ROUNDS; round++) rounds.push(await measureRound());
    const results = rounds.map(({ result }) => result);
    const tile = median(results.map(costOfTile));
    const snapshot = median(rounds.map((round) => round.snapshot));
    const ages = results.flatMap(({ tileAges }) => tileAges);
    const pauses = results.flatMap((result) => result.pauses);
    const longPollPauses = results.flatMap((result) => result.longPollPauses);
    const joins = results.flatMap((result) => result.joins);
    printRow("us of cpu", ["a tile", "a snapshot"]);
    printRow("", [tile, snapshot]);
    printRow("ms", ["p50", "p99"]);
    for (const [name, times] of [
      ["age of a tile", ages],
      ["pause at all 40", pauses],
      ["by long polling", longPollPauses],
      ["200 joins at once", joins],
    ] as const) {
      printRow(name, [quantile(times, 0.5), quantile(times, 0.99)]);
    }
    const onRedis = await measureOnRedis();
    printRow("on Redis", ["records per second", "us of relay", "us of Redis"]);
    printRow("", [onRedis.recordsPerSecond, onRedis.relay, onRedis.redis]);
    const ratios = rounds.map((round) => costOfTile(round.result) / round.snapshot);
    return [
      {
        label: "processor time of a tile, relative to a snapshot",
        measured: median(ratios),
        bound: { atMost: 1.3 },
        unit: "times",
      },
      milliseconds("age of a tile at the dashboard, p99", ages, 1_000),
      milliseconds("from a pause to all 40 students, p99", pauses, 300),
      milliseconds("the same by long polling, p99", longPollPauses, 1_500),
      milliseconds("200 students join from one address at once, p99", joins, 2_000),
      {
        label: "classes of 40 that one core of Redis serves",
        measured: onRedis.classes,
        bound: { atLeast: 1_000 },
        unit: "classes",
      },
    ];
  },
};

/** Measures classes and robots at a new relay. */
async function measureRound(): Promise<{ result: ClassesResult; snapshot: number }> {
  const running = await startPeer("corridor", false);
  const [pid] = running?.pids ?? [];
  if (running === null || pid === undefined) throw new Error("the relay has not started");
  const { pages: port, readers } = running;
  const load = Load.start();
  try {
    const fleet = await load.open({
      peer: "corridor",
      pages: port,
      readers,
      robots: ROBOTS,
      scripts: 0,
    });
    const paced = await load.paced({ fleet, pids: running.pids, ...SNAPSHOTS });
    await load.close(fleet);
    const result = await runClasses({ port, pids: [pid], ...CLASSES });
    return { result, snapshot: costPerItem(paced) };
  } finally {
    await load.stop();
    await running.stop();
  }
}

/**
 * Measures classes at a relay that stores its data in Redis: costs per record, and capacity. What
 * Redis needs without records does not grow with the number of classes.
 */
async function measureOnRedis() {
  const running = await startRelayOnRedis();
  if (running === null) {
    const missing = Number.NaN;
    return { recordsPerSecond: missing, relay: missing, redis: missing, classes: missing };
  }
  try {
    const { pages: port, pids } = running;
    const idle = await idleShare(pids[1]);
    const { seconds, stored, processorMs: spent } = await runClasses({ port, pids, ...ON_REDIS });
    const [relay = Number.NaN, redis = Number.NaN] = spent;
    return {
      recordsPerSecond: stored / seconds,
      relay: (relay * 1000) / stored,
      redis: (redis * 1000) / stored,
      classes:
        ((stored / seconds / RECORDS_PER_CLASS) * (1 - idle)) / (redis / (seconds * 1000) - idle),
    };
  } finally {
    await running.stop();
  }
}

/** The share of a core that a process without work needs. */
async function idleShare(pid = Number.NaN): Promise<number> {
  const before = { processor: processorMs(pid), at: performance.now() };
  await delay(ON_REDIS.seconds * 1000);
  return (processorMs(pid) - before.processor) / (performance.now() - before.at);
}

async function runClasses(job: ClassesJob): Promise<ClassesResult> {
  const file = join(import.meta.dirname, "load-process.ts");
  const child = fork(file, { serialization: "advanced" });
  const ended = once(child, "exit");
  const result = (await ask(child, job)) as ClassesResult;
  child.disconnect();
  await ended;
  return result;
}

const costOfTile = ({ processorMs: [relay = Number.NaN], tiles }: ClassesResult): number =>
  (relay * 1000) / tiles;

function milliseconds(label: string, times: readonly number[], atMost: number): Goal {
  return { label, measured: quantile(times, 0.99), bound: { atMost }, unit: "ms" };
}
