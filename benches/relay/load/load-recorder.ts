/** Records the results of the load: send times, latencies, and the time of answers and starts. */
import { processorMs } from "../process-metrics.ts";
import type { FleetListener } from "../fleets/fleet.ts";
import type { LoadResult } from "./jobs.ts";

/**
 * Number of stored send times per robot. A snapshot must arrive before this many later snapshots.
 */
const MAX_SENT_TIMES = 256;

export class LoadRecorder implements FleetListener {
  readonly #sent: Float64Array[];
  readonly #numbers: number[];
  readonly #unanswered: number[][];
  readonly #unstarted: number[][];
  #result: Omit<LoadResult, "seconds" | "processorMs"> | null = null;
  /** called when a robot's reader receives a snapshot, or the answer to a command */
  snapshotObserver: (robot: number, n: number) => void = () => undefined;
  answerObserver: (robot: number) => void = () => undefined;

  constructor(robots: number) {
    const each = <T>(create: () => T): T[] => Array.from({ length: robots }, create);
    this.#sent = each(() => new Float64Array(MAX_SENT_TIMES));
    this.#numbers = each(() => 0);
    this.#unanswered = each(() => []);
    this.#unstarted = each(() => []);
  }

  /** Records the send time of a robot's next snapshot. @returns its number */
  nextSnapshot(robot: number): number {
    const n = (this.#numbers[robot] ?? 0) + 1;
    this.#numbers[robot] = n;
    const sent = this.#sent[robot];
    if (sent !== undefined) sent[n % MAX_SENT_TIMES] = performance.now();
    return n;
  }

  recordCommand(robot: number): void {
    const now = performance.now();
    this.#unanswered[robot]?.push(now);
    this.#unstarted[robot]?.push(now);
  }

  onSnapshot(robot: number, n: number): void {
    const sentAt = this.#sent[robot]?.[n % MAX_SENT_TIMES] ?? Number.NaN;
    if (this.#result !== null) {
      this.#result.forwarded += 1;
      this.#result.latencies.push(performance.now() - sentAt);
    }
    this.snapshotObserver(robot, n);
  }

  onAnswer(robot: number): void {
    const sentAt = this.#unanswered[robot]?.shift();
    if (sentAt === undefined) throw new Error("received an answer without a pending command");
    this.#result?.answers.push(performance.now() - sentAt);
    this.answerObserver(robot);
  }

  /** A velocity started. It may have replaced earlier ones, which never start. */
  onVelocity(robot: number): void {
    const sentAt = this.#unstarted[robot]?.splice(0).at(-1);
    if (sentAt !== undefined) this.#result?.starts.push(performance.now() - sentAt);
  }

  onStarted(robot: number): void {
    const sentAt = this.#unstarted[robot]?.shift();
    if (sentAt !== undefined) this.#result?.starts.push(performance.now() - sentAt);
  }

  /** Counts a processed snapshot or an answered command. */
  countDone(): void {
    if (this.#result !== null) this.#result.done += 1;
  }

  /** Records for a number of seconds, after a warm-up. */
  async record(seconds: number, pids: readonly number[]): Promise<LoadResult> {
    await delay(WARM_UP_MS);
    const result = { done: 0, forwarded: 0, latencies: [], answers: [], starts: [] };
    const before = pids.map(processorMs);
    const startedAt = performance.now();
    this.#result = result;
    await delay(seconds * 1000);
    this.#result = null;
    const elapsed = (performance.now() - startedAt) / 1000;
    const spent = pids.map((pid, at) => processorMs(pid) - (before[at] ?? 0));
    return { ...result, seconds: elapsed, processorMs: spent };
  }
}

const WARM_UP_MS = 400;

export function delay(ms: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, ms));
}
