/**
 * Records what scripts, robot and store observe of every command, and checks the required
 * properties.
 */
import { hasEnded, type CommandRecord, type CommandState } from "@corridor/protocol";

interface Action {
  seq: number;
  /** the page that hosted the robot, numbered in order */
  page: number;
  what: CommandState;
  at: number;
}

interface Try {
  /** a client that sends commands sequentially */
  sender: string;
  at: number;
  ttl: number;
  /**
   * the script sends a timestamp with each attempt, so that transit time must not make its command
   * late
   */
  isTimed?: boolean;
}

/** The first attempt of a command, and the times of its retries. */
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
/** Maximum difference between an attempt and the age in it. */
const AGE_MS = 25;

export class History {
  /** ms after its ttl within which a command may start */
  readonly #tolerance: number;
  /** converts a time of this history to the relay's clock */
  readonly #wallClock: (at: number) => number;
  #longestTransit = 0;
  /** by number: start deadlines of the relay, by its clock */
  readonly #deadlines = new Map<number, number>();
  #actions: Action[] = [];
  /** by idempotency key: first attempt and its terms */
  readonly #tries = new Map<string, Tries>();
  readonly #acknowledged = new Map<number, CommandRecord>();
  /** as reported to scripts */
  readonly #endings = new Map<number, CommandState>();
  readonly #faults: Fault[] = [];

  constructor(tolerance: number, wallClock: (at: number) => number = (at) => at) {
    this.#tolerance = tolerance;
    this.#wallClock = wallClock;
  }

  /** Longest transit time of an attempt in ms, including the network and waits for a processor. */
  get longestTransit(): number {
    return this.#longestTransit;
  }

  tried(key: string, attempt: Try): void {
    const first = this.#tries.get(key);
    if (first === undefined) this.#tries.set(key, { ...attempt, again: [] });
    else first.again.push(Math.round(attempt.at - first.at));
  }

  acknowledged(record: CommandRecord): void {
    const before = this.#acknowledged.get(record.seq);
    if (before !== undefined && before.key !== record.key) {
      this.#report("doubled", `${record.seq} was acknowledged to ${before.key} and ${record.key}`);
    }
    this.#acknowledged.set(record.seq, record);
    this.reported(record);
  }

  /**
   * Records that the relay has delivered a command to the robot. @param deadline by the relay's
   * clock
   */
  given(seq: number, deadline: number): void {
    if (!this.#deadlines.has(seq)) this.#deadlines.set(seq, deadline);
  }

  reported({ seq, state }: CommandRecord): void {
    if (!hasEnded(state)) return;
    const before = this.#endings.get(seq);
    if (before !== undefined && before !== state) {
      this.#report("ended twice", `${seq} was reported as ${before}, then as ${state}`);
    }
    this.#endings.set(seq, state);
  }

  did(action: Action): void {
    this.#actions.push(action);
  }

  /**
   * Removes the actions of a closed page that no one can know of: endings without a start, and
   * unreported actions.
   * @param isKnown whether anyone can know of an action
   */
  left(page: number, isKnown: (seq: number, at: number) => boolean = () => true): void {
    this.#actions = this.#actions.filter(
      (action) => action.page !== page || isKnown(action.seq, action.at),
    );
    const begun = new Set(
      this.#actions.flatMap(({ seq, what }) => (what === "started" ? [seq] : [])),
    );
    this.#actions = this.#actions.filter((action) => action.page !== page || begun.has(action.seq));
  }

  /** Current state of the commands that a page has started. */
  startedBy(page: number): { seq: number; what: CommandState }[] {
    const now = new Map<number, CommandState>();
    for (const { seq, what, page: by } of this.#actions) {
      if (by === page && (what === "started" || now.has(seq))) now.set(seq, what);
    }
    return [...now].map(([seq, what]) => ({ seq, what }));
  }

  /** Compares the observations with the final content of the store. */
  check(stored: readonly CommandRecord[]): Fault[] {
    stored.forEach(({ seq }, index) => {
      if (seq !== index + 1) this.#report("lost", `the store lacks ${index + 1}`);
    });
    for (const { seq, key } of this.#acknowledged.values()) {
      if (stored[seq - 1]?.key !== key) this.#report("lost", `${seq} was acknowledged and lost`);
    }
    for (const record of stored) this.#checkOne(record);
    this.#checkStored(stored);
    this.#checkOrder();
    return this.#faults;
  }

  #report(kind: FaultKind, words: string): void {
    this.#faults.push({ kind, words });
  }

  #attemptOf(key: string | null): Tries | null {
    return key === null ? null : (this.#tries.get(key) ?? null);
  }

  #checkOne({ seq, key, state, reason, action, acceptedAt }: CommandRecord): void {
    const actions = this.#actions.filter((action) => action.seq === seq);
    const starts = actions.filter(({ what }) => what === "started");
    const ends = actions.filter(({ what }) => hasEnded(what));
    const endedTwice = (words: string): void => this.#report("ended twice", `${seq} ${words}`);
    if (!hasEnded(state)) this.#report("lost", `${seq} never ended: ${state}`);
    if (starts.length > 1) this.#report("doubled", `${seq} started ${starts.length} times`);
    if (ends.length > 1) {
      endedTwice(`ended as ${ends.map(({ what, page }) => `${what} (page ${page})`).join(", ")}`);
    }
    const reported = this.#endings.get(seq);
    if (reported !== undefined && reported !== state)
      endedTwice(`is ${state} and was reported as ${reported}`);
    const [start] = starts;
    const [end] = ends;
    // The link executes a stop before the driver can report it.
    const isDone = action !== "stop" && (state === "completed" || state === "collided");
    if (isDone && end?.what !== state) endedTwice(`is ${state}, the robot reported ${end?.what}`);
    if (state === "expired" && start !== undefined) endedTwice("expired and was started");
    // The relay writes these reasons only for commands that no robot has.
    const byRelay =
      /^Command \d+ (stopped|replaced) this|^The script cancelled this command before/.test(
        reason ?? "",
      );
    if (byRelay && start !== undefined) endedTwice(`was started and ${state}: ${reason}`);
    const isLost = /robot disconnected|page was reloaded|Another page took over/.test(reason ?? "");
    if (end !== undefined && end.what !== state && !isLost) {
      endedTwice(`is ${state} (${reason}), the robot ended it as ${end.what}`);
    }
    const attempt = this.#attemptOf(key);
    if (start !== undefined && attempt !== null) {
      const transitOf = (): number =>
        this.#transitOf(attempt, Date.parse(acceptedAt), this.#deadlines.get(seq));
      const transit = attempt.isTimed === true ? 0 : transitOf();
      const late = start.at - attempt.at - attempt.ttl - transit;
      if (late > this.#tolerance) {
        const { sender, ttl, again } = attempt;
        const terms = `of ${sender}, ttl ${ttl} ms, tried again after ${again.join(", ") || "nothing"} ms`;
        this.#report("late", `${seq} (${action} ${terms}) started ${Math.round(late)} ms late`);
      }
    }
  }

  /**
   * Transit time of the attempt that the relay accepted. A relay cannot deduct it unless the script
   * sends timestamps. The age that the relay used identifies the attempt. If no age matches, the
   * latest possible attempt counts.
   */
  #transitOf({ at, again, ttl }: Tries, arrivedAt: number, deadline: number | undefined): number {
    const age = deadline === undefined ? NaN : arrivedAt + ttl - deadline;
    const matching = [0, ...again].filter((ms) => Math.abs(ms - age) <= AGE_MS);
    // Attempts older than their ttl are rejected, so an earlier attempt was accepted, after this
    // one.
    const possible = matching.length > 0 ? matching : [0, ...again.filter((ms) => ms < ttl)];
    const tries = possible.map((ms) => this.#wallClock(at + ms));
    // Clocks of two processes agree to about a millisecond.
    const taken = tries.findLast((tried) => tried <= arrivedAt + CLOCKS_MS) ?? arrivedAt;
    const transit = Math.max(0, arrivedAt - taken);
    this.#longestTransit = Math.max(this.#longestTransit, transit);
    return transit;
  }

  /** Checks one record per key, and the order of each sender. */
  #checkStored(stored: readonly CommandRecord[]): void {
    const seqs = new Map<string, number>();
    for (const { key, seq } of stored) {
      if (key === null) continue;
      const before = seqs.get(key);
      if (before !== undefined) this.#report("doubled", `${seq} is ${before} once more`);
      seqs.set(key, seq);
    }
    const last = new Map<string, number>();
    for (const [key, { sender }] of this.#tries) {
      const seq = seqs.get(key);
      if (seq === undefined) continue;
      const before = last.get(sender) ?? 0;
      if (seq <= before) this.#report("reordered", `${seq} was sent after ${before}`);
      last.set(sender, Math.max(before, seq));
    }
  }

  #checkOrder(): void {
    let last = 0;
    for (const { seq, what } of this.#actions) {
      if (what !== "started") continue;
      if (seq <= last) this.#report("reordered", `${seq} started after ${last}`);
      last = Math.max(last, seq);
    }
  }
}
