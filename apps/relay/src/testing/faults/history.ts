/** What scripts, robot and store have seen of every command, and what must be true of it. */
import { hasEnded, type CommandRecord, type CommandState } from "@corridor/protocol";

interface Deed {
  seq: number;
  /** pages that were the robot, one after the other */
  page: number;
  what: CommandState;
  at: number;
}

interface Try {
  /** whoever sends one command after the other */
  sender: string;
  at: number;
  ttl: number;
  /** the script says with each try when it was sent: no part of the way may make its command late */
  isTimed?: boolean;
}

/** The first try of a command, and when it was tried again. */
interface Tries extends Try {
  again: number[];
}

export const faultKinds = ["lost", "doubled", "reordered", "ended twice", "late"] as const;
export type FaultKind = (typeof faultKinds)[number];

export interface Fault {
  kind: FaultKind;
  words: string;
}

const CLOCKS_MS = 2;
/** A try and the age in it are of the same moment, or nearly. */
const AGE_MS = 25;

export class History {
  /** ms after its time to live within which a command may start */
  readonly #tolerance: number;
  /** a time of this history as the relay's clock has it */
  readonly #wallClock: (at: number) => number;
  #longestWay = 0;
  /** by number, until when the relay lets it begin, by its clock */
  readonly #deadlines = new Map<number, number>();
  #deeds: Deed[] = [];
  /** by idempotency key: first try, and what was wished */
  readonly #tries = new Map<string, Tries>();
  readonly #acknowledged = new Map<number, CommandRecord>();
  /** as scripts were told */
  readonly #endings = new Map<number, CommandState>();
  readonly #faults: Fault[] = [];

  constructor(tolerance: number, wallClock: (at: number) => number = (at) => at) {
    this.#tolerance = tolerance;
    this.#wallClock = wallClock;
  }

  /** ms that a try needed to reach the relay, at most: the net, and processes that waited for a processor. */
  get longestWay(): number {
    return this.#longestWay;
  }

  tried(key: string, wish: Try): void {
    const first = this.#tries.get(key);
    if (first === undefined) this.#tries.set(key, { ...wish, again: [] });
    else first.again.push(Math.round(wish.at - first.at));
  }

  acknowledged(record: CommandRecord): void {
    const before = this.#acknowledged.get(record.seq);
    if (before !== undefined && before.key !== record.key) {
      this.#say("doubled", `${record.seq} was acknowledged to ${before.key} and ${record.key}`);
    }
    this.#acknowledged.set(record.seq, record);
    this.told(record);
  }

  /** The relay has given a command to the robot. @param deadline by the relay's clock */
  given(seq: number, deadline: number): void {
    if (!this.#deadlines.has(seq)) this.#deadlines.set(seq, deadline);
  }

  told({ seq, state }: CommandRecord): void {
    if (!hasEnded(state)) return;
    const before = this.#endings.get(seq);
    if (before !== undefined && before !== state) {
      this.#say("ended twice", `${seq} was told as ${before}, then as ${state}`);
    }
    this.#endings.set(seq, state);
  }

  did(deed: Deed): void {
    this.#deeds.push(deed);
  }

  /**
   * A page is gone: what it ended without having begun it, and told nobody, it may as well not have had.
   * @param isKnown whether anybody can know of what it did; the rest went with it
   */
  left(page: number, isKnown: (seq: number, at: number) => boolean = () => true): void {
    this.#deeds = this.#deeds.filter((deed) => deed.page !== page || isKnown(deed.seq, deed.at));
    const begun = new Set(
      this.#deeds.flatMap(({ seq, what }) => (what === "started" ? [seq] : [])),
    );
    this.#deeds = this.#deeds.filter((deed) => deed.page !== page || begun.has(deed.seq));
  }

  /** What a page has begun, as it is now. */
  begunBy(page: number): { seq: number; what: CommandState }[] {
    const now = new Map<number, CommandState>();
    for (const { seq, what, page: by } of this.#deeds) {
      if (by === page && (what === "started" || now.has(seq))) now.set(seq, what);
    }
    return [...now].map(([seq, what]) => ({ seq, what }));
  }

  /** Compares all that was seen with what the store has in the end. */
  check(stored: readonly CommandRecord[]): Fault[] {
    stored.forEach(({ seq }, index) => {
      if (seq !== index + 1) this.#say("lost", `the store lacks ${index + 1}`);
    });
    for (const { seq, key } of this.#acknowledged.values()) {
      if (stored[seq - 1]?.key !== key) this.#say("lost", `${seq} was acknowledged and lost`);
    }
    for (const record of stored) this.#checkOne(record);
    this.#checkStored(stored);
    this.#checkOrder();
    return this.#faults;
  }

  #say(kind: FaultKind, words: string): void {
    this.#faults.push({ kind, words });
  }

  #tryOf(key: string | null): Tries | null {
    return key === null ? null : (this.#tries.get(key) ?? null);
  }

  #checkOne({ seq, key, state, reason, action, acceptedAt }: CommandRecord): void {
    const deeds = this.#deeds.filter((deed) => deed.seq === seq);
    const starts = deeds.filter(({ what }) => what === "started");
    const ends = deeds.filter(({ what }) => hasEnded(what));
    const endedTwice = (words: string): void => this.#say("ended twice", `${seq} ${words}`);
    if (!hasEnded(state)) this.#say("lost", `${seq} never ended: ${state}`);
    if (starts.length > 1) this.#say("doubled", `${seq} started ${starts.length} times`);
    if (ends.length > 1) {
      endedTwice(`ended as ${ends.map(({ what, page }) => `${what} (page ${page})`).join(", ")}`);
    }
    const told = this.#endings.get(seq);
    if (told !== undefined && told !== state) endedTwice(`is ${state} and was told as ${told}`);
    const [start] = starts;
    const [end] = ends;
    // A stop is done by the link, before the driver could tell.
    const isDone = action !== "stop" && (state === "completed" || state === "collided");
    if (isDone && end?.what !== state) endedTwice(`is ${state}, the robot says ${end?.what}`);
    if (state === "expired" && start !== undefined) endedTwice("expired and was started");
    // The relay writes these for what no robot has.
    const byRelay = /^(stopped|replaced) by command|^Its script cancelled it before/.test(
      reason ?? "",
    );
    if (byRelay && start !== undefined) endedTwice(`was started and ${state}: ${reason}`);
    const isLost = /page is gone|page was reloaded|another page took/.test(reason ?? "");
    if (end !== undefined && end.what !== state && !isLost) {
      endedTwice(`is ${state} (${reason}), the robot ended it as ${end.what}`);
    }
    const wish = this.#tryOf(key);
    if (start !== undefined && wish !== null) {
      const wayOf = (): number =>
        this.#wayOf(wish, Date.parse(acceptedAt), this.#deadlines.get(seq));
      const way = wish.isTimed === true ? 0 : wayOf();
      const late = start.at - wish.at - wish.ttl - way;
      if (late > this.#tolerance) {
        const { sender, ttl, again } = wish;
        const terms = `of ${sender}, ttl ${ttl} ms, tried again after ${again.join(", ") || "nothing"} ms`;
        this.#say("late", `${seq} (${action} ${terms}) started ${Math.round(late)} ms late`);
      }
    }
  }

  /**
   * How long the try that the relay took was on its way, which no relay can take off where the script does not say
   * when it sent it. Which try it was shows the age that the relay has
   * counted from; where that is the age of none, or not known, it was the newest that it can have been.
   */
  #wayOf({ at, again, ttl }: Tries, arrivedAt: number, deadline: number | undefined): number {
    const age = deadline === undefined ? NaN : arrivedAt + ttl - deadline;
    const told = [0, ...again].filter((ms) => Math.abs(ms - age) <= AGE_MS);
    // A try that is older than its time to live is refused: an earlier one was taken, which came after it.
    const possible = told.length > 0 ? told : [0, ...again.filter((ms) => ms < ttl)];
    const tries = possible.map((ms) => this.#wallClock(at + ms));
    // Clocks of two processes agree to a millisecond or so.
    const taken = tries.findLast((tried) => tried <= arrivedAt + CLOCKS_MS) ?? arrivedAt;
    const way = Math.max(0, arrivedAt - taken);
    this.#longestWay = Math.max(this.#longestWay, way);
    return way;
  }

  /** One row for each key, and for each sender the order in which it sent. */
  #checkStored(stored: readonly CommandRecord[]): void {
    const seqs = new Map<string, number>();
    for (const { key, seq } of stored) {
      if (key === null) continue;
      const before = seqs.get(key);
      if (before !== undefined) this.#say("doubled", `${seq} is ${before} once more`);
      seqs.set(key, seq);
    }
    const last = new Map<string, number>();
    for (const [key, { sender }] of this.#tries) {
      const seq = seqs.get(key);
      if (seq === undefined) continue;
      const before = last.get(sender) ?? 0;
      if (seq <= before) this.#say("reordered", `${seq} was sent after ${before}`);
      last.set(sender, Math.max(before, seq));
    }
  }

  #checkOrder(): void {
    let last = 0;
    for (const { seq, what } of this.#deeds) {
      if (what !== "started") continue;
      if (seq <= last) this.#say("reordered", `${seq} started after ${last}`);
      last = Math.max(last, seq);
    }
  }
}
