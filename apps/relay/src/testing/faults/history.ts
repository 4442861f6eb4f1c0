/** What scripts, robot and store have seen of every command, and what must be true of it. */
import { hasEnded, type CommandRecord, type CommandState } from "@corridor/protocol";

interface Deed {
  seq: number;
  /** pages that were the robot, one after the other */
  page: number;
  what: CommandState;
  at: number;
}

/** A command crosses two lines, and the robot looks at its clock at each step. */
const TOLERANCE_MS = 120;

export class History {
  #deeds: Deed[] = [];
  /** by idempotency key: first try, and what was wished */
  readonly #tries = new Map<string, { at: number; ttl: number }>();
  readonly #acknowledged = new Map<number, CommandRecord>();
  /** as scripts were told */
  readonly #endings = new Map<number, CommandState>();
  readonly faults: string[] = [];

  tried(key: string, ttl: number, at: number): void {
    if (!this.#tries.has(key)) this.#tries.set(key, { at, ttl });
  }

  acknowledged(record: CommandRecord): void {
    this.#acknowledged.set(record.seq, record);
    this.told(record);
  }

  told({ seq, state }: CommandRecord): void {
    if (!hasEnded(state)) return;
    const before = this.#endings.get(seq);
    if (before !== undefined && before !== state) {
      this.faults.push(`${seq} was told as ${before}, then as ${state}`);
    }
    this.#endings.set(seq, state);
  }

  did(deed: Deed): void {
    this.#deeds.push(deed);
  }

  /** A page is gone: what it ended without having begun it, and told nobody, it may as well not have had. */
  left(page: number): void {
    const begun = new Set(
      this.#deeds.flatMap(({ seq, what }) => (what === "started" ? [seq] : [])),
    );
    this.#deeds = this.#deeds.filter((deed) => deed.page !== page || begun.has(deed.seq));
  }

  /** Compares all that was seen with what the store has in the end. */
  check(stored: readonly CommandRecord[]): string[] {
    const say = (fault: string): void => void this.faults.push(fault);
    stored.forEach(({ seq }, index) => {
      if (seq !== index + 1) say(`the store lacks ${index + 1}`);
    });
    for (const { seq, key } of this.#acknowledged.values()) {
      if (stored[seq - 1]?.key !== key) say(`${seq} was acknowledged and lost`);
    }
    for (const record of stored) this.#checkOne(record, say);
    this.#checkOrder(say);
    return this.faults;
  }

  #checkOne(
    { seq, key, state, reason, action }: CommandRecord,
    say: (fault: string) => void,
  ): void {
    const deeds = this.#deeds.filter((deed) => deed.seq === seq);
    const starts = deeds.filter(({ what }) => what === "started");
    const ends = deeds.filter(({ what }) => hasEnded(what));
    if (!hasEnded(state)) say(`${seq} never ended: ${state}`);
    if (starts.length > 1) say(`${seq} started ${starts.length} times`);
    if (ends.length > 1) say(`${seq} ended twice: ${ends.map(({ what }) => what).join(", ")}`);
    const told = this.#endings.get(seq);
    if (told !== undefined && told !== state) say(`${seq} is ${state} and was told as ${told}`);
    const [start] = starts;
    const [end] = ends;
    // A stop is done by the link, before the driver could tell.
    const isDone = action !== "stop" && (state === "completed" || state === "collided");
    if (isDone && end?.what !== state) say(`${seq} is ${state}, the robot says ${end?.what}`);
    if (state === "expired" && start !== undefined) say(`${seq} expired and was started`);
    // The relay writes these for what no robot has.
    const byRelay = /^(stopped|replaced) by command|^cancelled by its sender/.test(reason ?? "");
    if (byRelay && start !== undefined) say(`${seq} was started and ${state}: ${reason}`);
    const isLost = /page is gone|page was reloaded/.test(reason ?? "");
    if (end !== undefined && end.what !== state && !isLost) {
      say(`${seq} is ${state} (${reason}), the robot ended it as ${end.what}`);
    }
    const wish = key === null ? undefined : this.#tries.get(key);
    if (start !== undefined && wish !== undefined) {
      const late = start.at - wish.at - wish.ttl;
      if (late > TOLERANCE_MS) say(`${seq} started ${late} ms too late`);
    }
  }

  #checkOrder(say: (fault: string) => void): void {
    let last = 0;
    for (const { seq, what } of this.#deeds) {
      if (what !== "started") continue;
      if (seq <= last) say(`${seq} started after ${last}`);
      last = Math.max(last, seq);
    }
  }
}
