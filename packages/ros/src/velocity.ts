/**
 * The velocity of `/cmd_vel`: a register with a lease, never a queue. Clients store what they publish
 * while they are disconnected, and send all of it at once later.
 */
import type { Order } from "@corridor/protocol";
import { wheelPowers, type Velocity } from "./conversions.ts";
import type { Timers } from "./timers.ts";

/** At most 10 orders a second. */
const MIN_INTERVAL_MS = 100;
/** An unchanged value is sent again after this time, while messages arrive. */
const RENEWAL_MS = 200;
/** The robot stops if no message arrives for this time. */
const LEASE_MS = 500;
/** A connection begins with what its client has stored. */
const START_MS = 300;
const MAX_DELAY_MS = 500;

interface Powers {
  left: number;
  right: number;
}

export interface VelocityOptions {
  timers: Timers;
  /** Sends an order. It settles when the next one may be sent, and never rejects. */
  send(order: Order): Promise<void>;
}

export class VelocityRegister {
  readonly #options: VelocityOptions;
  readonly #startedAt: number;
  /** the newest value that has not been sent */
  #next: Powers | null = null;
  #sent: Powers | null = null;
  #sentAt = Number.NEGATIVE_INFINITY;
  #cancelTimer: (() => void) | null = null;
  #isSending = false;
  #isClosed = false;
  /** the largest difference between the stamp of a message and its arrival, in ms */
  #offset = Number.NEGATIVE_INFINITY;

  constructor(options: VelocityOptions) {
    this.#options = options;
    this.#startedAt = options.timers.now();
  }

  /** @param stampMs the time of the message by the clock of the client; null: none */
  set(velocity: Velocity, stampMs: number | null): void {
    if (stampMs !== null && this.#isLate(stampMs)) return;
    this.#next = wheelPowers(velocity);
    this.#schedule();
  }

  close(): void {
    this.#isClosed = true;
    this.#cancelTimer?.();
  }

  #isLate(stampMs: number): boolean {
    const offset = stampMs - this.#options.timers.now();
    this.#offset = Math.max(this.#offset, offset);
    return offset < this.#offset - MAX_DELAY_MS;
  }

  #schedule(): void {
    if (this.#isSending || this.#isClosed || this.#cancelTimer !== null) return;
    const { timers } = this.#options;
    const dueAt = Math.max(this.#startedAt + START_MS, this.#sentAt + MIN_INTERVAL_MS);
    // Not at once: of messages that arrive together, only the newest counts.
    this.#cancelTimer = timers.after(Math.max(0, dueAt - timers.now()), () => {
      this.#cancelTimer = null;
      void this.#sendNext();
    });
  }

  async #sendNext(): Promise<void> {
    const powers = this.#next;
    this.#next = null;
    if (powers === null || !this.#isDue(powers)) return;
    this.#sent = powers;
    this.#sentAt = this.#options.timers.now();
    this.#isSending = true;
    const terms = { lease: LEASE_MS, ttl: LEASE_MS, replace: true };
    await this.#options.send({ action: "drive", ...powers, ...terms });
    this.#isSending = false;
    if (this.#next !== null) this.#schedule();
  }

  #isDue({ left, right }: Powers): boolean {
    if (this.#sent?.left !== left || this.#sent.right !== right) return true;
    const isZero = left === 0 && right === 0;
    return !isZero && this.#options.timers.now() - this.#sentAt >= RENEWAL_MS;
  }
}
