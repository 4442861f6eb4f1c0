/**
 * The motion of a client of another protocol: a register, never a queue. A velocity has a lease; a turn
 * ends by itself. Clients store what they send while they are disconnected, and send all of it at once
 * later.
 */
import { MAX_CLOCK_DRIFT } from "./clock-drift.ts";
import type { Order } from "./order.ts";
import { LEASE_MS } from "./term-bounds.ts";
import type { Timers } from "./timers.ts";

/** At most 10 orders a second. */
const MIN_INTERVAL_MS = 100;
/** An unchanged value is sent again after this time, while messages arrive. */
const RENEWAL_MS = 200;
/** The robot stops if no message arrives for this time. */
const SILENT_MS = LEASE_MS.default;
/** A turn is sent once, so it may start later than a velocity. */
const TURN_TTL_MS = 2_000;
/** A connection begins with what its client has stored, and so does one that was interrupted. */
const START_MS = 300;
/** Of a stream that resumes, messages that arrive this close together may be what was stored. */
const SETTLE_MS = 50;
/** More messages than this in `SETTLE_MS` were stored. */
const MAX_SETTLING = 3;
const MAX_DELAY_MS = 500;
/** Stamps that are late for this time, but advance like the clock here, show a clock that was set. */
const CLOCK_SET_MS = 1_000;
/** What is stored arrives faster than it was sent, by more than this within `CLOCK_SET_MS`. */
const MAX_JITTER_MS = 250;
/** Snapshots are late by fewer orders than this. */
const MAX_OWN = 32;
/** A stamp that is at most this far behind the simulated time shows that time, not a clock. */
const MAX_BEHIND_MS = 600_000;
/** Clients may be ahead of the simulated time by the interval of snapshots. */
const MAX_AHEAD_MS = 1_000;

/** Wheel powers from -1 to 1, or degrees to turn on the spot (negative: left). */
export type Motion =
  | { action: "drive"; left: number; right: number }
  | { action: "turn"; degrees: number };

export interface MotionRegisterOptions {
  timers: Timers;
  /** Number of the command that runs; null: none. */
  running(): number | null;
  /** Whether another command of this client runs or waits. */
  hasOther(): boolean;
  /**
   * Sends an order. Never rejects.
   * @returns number of its command, once the next order may be sent; null if it was refused
   */
  send(order: Order): Promise<number | null>;
}

export class MotionRegister {
  readonly #options: MotionRegisterOptions;
  /** nothing is sent before this time: of what arrives until then, only the newest value counts */
  #heldUntil: number;
  #arrivedAt = Number.NEGATIVE_INFINITY;
  /** whether the newest two messages came within the lease, as those of a stream do */
  #isStream = false;
  /** the newest time at which a stream resumed, and the number of messages soon after it */
  #resumed = { at: Number.NEGATIVE_INFINITY, messages: 0 };
  /** the newest value that has not been sent, and the time of its arrival */
  #next: { motion: Motion; at: number } | null = null;
  /** null: the robot may do something else */
  #sent: Motion | null = null;
  #sentAt = Number.NEGATIVE_INFINITY;
  #cancelTimer: (() => void) | null = null;
  /** numbers of the newest velocities of this register */
  readonly #own = new Set<number>();
  #isSending = false;
  #isClosed = false;
  /** the largest difference between the stamp of a message and its arrival, in ms */
  #offset = Number.NEGATIVE_INFINITY;
  /** the first of the late messages since the last one in time; null: there was none */
  #lateSince: { stampMs: number; at: number } | null = null;
  /** simulated times of the last `MAX_DELAY_MS`, and the newest before it */
  readonly #simulated: { at: number; ms: number }[] = [];

  constructor(options: MotionRegisterOptions) {
    this.#options = options;
    this.#heldUntil = options.timers.now() + START_MS;
  }

  /** @param stampMs the time of the message by the clock of the client; null: none */
  set(motion: Motion, stampMs: number | null): void {
    this.#arrived(this.#options.timers.now());
    if (stampMs !== null && this.#isLate(stampMs)) return;
    this.#next = { motion, at: this.#options.timers.now() };
    this.#schedule();
  }

  /** The robot reports. @param ms simulated time */
  simulated(ms: number): void {
    const at = this.#options.timers.now();
    const times = this.#simulated;
    // After a reset, the time begins again.
    if (ms < (times.at(-1)?.ms ?? 0)) times.length = 0;
    times.push({ at, ms });
    while ((times[1]?.at ?? at) <= at - MAX_DELAY_MS) times.shift();
  }

  /**
   * Another command is sent, and ends here what arrived before it. The next velocity takes over from
   * that command, even if it is the same.
   * @returns whether a value has not been sent: it would have taken over from earlier commands
   */
  overtaken(): boolean {
    const hasValue = this.#next !== null;
    this.#next = null;
    this.#sent = null;
    return hasValue;
  }

  /** Whether a command is one of the newest velocities. */
  owns(seq: number): boolean {
    return this.#own.has(seq);
  }

  /** The client sends nothing more: the newest value does not wait for a newer one. */
  finish(): void {
    if (this.#cancelTimer === null) return;
    this.#cancelTimer();
    this.#cancelTimer = null;
    void this.#sendNext();
  }

  close(): void {
    this.#isClosed = true;
    this.#cancelTimer?.();
  }

  /**
   * A stalled connection delivers at once what its client has sent meanwhile, and its client has not
   * noticed anything. So a stream that resumes after a silence waits: for a moment, or if many
   * messages arrive, as long as a new connection.
   */
  #arrived(now: number): void {
    const isClose = now - this.#arrivedAt <= SILENT_MS;
    if (!isClose && this.#isStream) {
      this.#resumed = { at: now, messages: 0 };
      this.#heldUntil = Math.max(this.#heldUntil, now + SETTLE_MS);
    }
    this.#isStream = isClose;
    this.#arrivedAt = now;
    const { at } = this.#resumed;
    if (now - at > SETTLE_MS) return;
    this.#resumed.messages += 1;
    if (this.#resumed.messages > MAX_SETTLING) {
      this.#heldUntil = Math.max(this.#heldUntil, at + START_MS);
    }
  }

  #isLate(stampMs: number): boolean {
    const newest = this.#simulated.at(-1)?.ms ?? 0;
    const isSimulated = stampMs <= newest + MAX_AHEAD_MS && stampMs >= newest - MAX_BEHIND_MS;
    // Simulated time passes at another rate than the clock here.
    if (isSimulated) return stampMs < this.#simulatedBefore();
    const at = this.#options.timers.now();
    const offset = stampMs - at * (1 - MAX_CLOCK_DRIFT);
    this.#offset = Math.max(this.#offset, offset);
    if (offset >= this.#offset - MAX_DELAY_MS) {
      this.#lateSince = null;
      return false;
    }
    this.#lateSince ??= { stampMs, at };
    const passed = at - this.#lateSince.at;
    const isInStep = Math.abs(stampMs - this.#lateSince.stampMs - passed) <= MAX_JITTER_MS;
    if (passed < CLOCK_SET_MS || !isInStep) return true;
    this.#offset = offset;
    this.#lateSince = null;
    return false;
  }

  /** The simulated time `MAX_DELAY_MS` ago; no time if it is unknown. */
  #simulatedBefore(): number {
    const [oldest] = this.#simulated;
    const isOld = oldest !== undefined && oldest.at <= this.#options.timers.now() - MAX_DELAY_MS;
    return isOld ? oldest.ms : Number.NEGATIVE_INFINITY;
  }

  #schedule(): void {
    if (this.#isSending || this.#isClosed || this.#cancelTimer !== null) return;
    const { timers } = this.#options;
    const dueAt = Math.max(this.#heldUntil, this.#sentAt + MIN_INTERVAL_MS);
    // Not at once: of messages that arrive together, only the newest counts.
    this.#cancelTimer = timers.after(Math.max(0, dueAt - timers.now()), () => {
      this.#cancelTimer = null;
      if (timers.now() < this.#heldUntil) this.#schedule();
      else void this.#sendNext();
    });
  }

  async #sendNext(): Promise<void> {
    const next = this.#next;
    this.#next = null;
    if (next === null) return;
    const { motion, at } = next;
    // Sending an earlier order took long, because the network was lost.
    if (at < this.#options.timers.now() - MAX_DELAY_MS) return;
    if (!this.#isDue(motion)) return;
    const order = this.#orderOf(motion);
    this.#sent = motion;
    this.#sentAt = this.#options.timers.now();
    this.#isSending = true;
    const seq = await this.#options.send(order);
    if (seq === null) this.#sent = null;
    this.#isSending = false;
    if (seq !== null && motion.action === "drive") this.#remember(seq);
    if (this.#next !== null) this.#schedule();
  }

  #orderOf(motion: Motion): Order {
    if (motion.action === "turn") return { ...motion, ttl: TURN_TTL_MS, replace: true };
    return { ...motion, lease: SILENT_MS, ttl: SILENT_MS, replace: this.#mustTakeOver() };
  }

  /** A drive replaces an earlier one by itself, and waits for other commands. */
  #mustTakeOver(): boolean {
    if (this.#sent?.action === "turn") return true;
    const running = this.#options.running();
    return this.#options.hasOther() || (running !== null && !this.#own.has(running));
  }

  #remember(seq: number): void {
    this.#own.add(seq);
    const [oldest] = this.#own;
    if (this.#own.size > MAX_OWN && oldest !== undefined) this.#own.delete(oldest);
  }

  #isDue(motion: Motion): boolean {
    if (motion.action !== "drive" || this.#sent?.action !== "drive") return true;
    const { left, right } = motion;
    if (this.#sent.left !== left || this.#sent.right !== right) return true;
    const isZero = left === 0 && right === 0;
    return !isZero && this.#options.timers.now() - this.#sentAt >= RENEWAL_MS;
  }
}
