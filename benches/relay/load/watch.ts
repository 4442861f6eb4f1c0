/** Notes what comes of the load: when each thing was said, and how long it took until it was heard. */
import { processorMs } from "../process-figures.ts";
import type { Ears } from "../fleets/fleet.ts";
import type { Seen } from "./jobs.ts";

/** Sent times of the newest snapshots of a robot; one that comes later than that many after it counts as lost. */
const REMEMBERED = 256;

export class Watch implements Ears {
  readonly #sent: Float64Array[];
  readonly #numbers: number[];
  readonly #unanswered: number[][];
  readonly #unbegun: number[][];
  #seen: Omit<Seen, "seconds" | "processorMs"> | null = null;
  /** is called when a robot's reader got a snapshot, or its command's answer */
  heardSnapshot: (robot: number, n: number) => void = () => undefined;
  heardAnswer: (robot: number) => void = () => undefined;

  constructor(robots: number) {
    const each = <T>(make: () => T): T[] => Array.from({ length: robots }, make);
    this.#sent = each(() => new Float64Array(REMEMBERED));
    this.#numbers = each(() => 0);
    this.#unanswered = each(() => []);
    this.#unbegun = each(() => []);
  }

  /** @returns the number of the robot's next snapshot, which leaves now */
  reports(robot: number): number {
    const n = (this.#numbers[robot] ?? 0) + 1;
    this.#numbers[robot] = n;
    const sent = this.#sent[robot];
    if (sent !== undefined) sent[n % REMEMBERED] = performance.now();
    return n;
  }

  commands(robot: number): void {
    const now = performance.now();
    this.#unanswered[robot]?.push(now);
    this.#unbegun[robot]?.push(now);
  }

  snapshot(robot: number, n: number): void {
    const sentAt = this.#sent[robot]?.[n % REMEMBERED] ?? Number.NaN;
    if (this.#seen !== null) {
      this.#seen.passed += 1;
      this.#seen.ways.push(performance.now() - sentAt);
    }
    this.heardSnapshot(robot, n);
  }

  answered(robot: number): void {
    const sentAt = this.#unanswered[robot]?.shift();
    if (sentAt === undefined) throw new Error("an answer that nobody waits for");
    this.#seen?.answers.push(performance.now() - sentAt);
    this.heardAnswer(robot);
  }

  began(robot: number): void {
    const sentAt = this.#unbegun[robot]?.shift();
    if (sentAt !== undefined) this.#seen?.beginnings.push(performance.now() - sentAt);
  }

  /** One more snapshot was taken, or command answered. */
  done(): void {
    if (this.#seen !== null) this.#seen.done += 1;
  }

  /** Notes for so long what happens, once it has gone on for a moment. */
  async during(seconds: number, pids: readonly number[]): Promise<Seen> {
    await pause(LEAD_IN_MS);
    const seen = { done: 0, passed: 0, ways: [], answers: [], beginnings: [] };
    const before = pids.map(processorMs);
    const since = performance.now();
    this.#seen = seen;
    await pause(seconds * 1000);
    this.#seen = null;
    const took = (performance.now() - since) / 1000;
    const spent = pids.map((pid, at) => processorMs(pid) - (before[at] ?? 0));
    return { ...seen, seconds: took, processorMs: spent };
  }
}

const LEAD_IN_MS = 400;

export function pause(ms: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, ms));
}
