/**
 * Whether this relay should be sent work: the store answers and nobody has asked it to end.
 *
 * A full disk makes it `degraded`, not unready: robots and scripts go on reading and moving, and taking
 * the relay away would end that too.
 */
import type { Logger } from "pino";
import type { Clock } from "./clock.ts";
import type { SessionStore } from "./store/session-store.ts";

/** Asking the store costs a commit; whoever asks more often gets the same answer. */
const FRESH_MS = 2_000;

export type ReadyStatus = "ready" | "degraded" | "draining" | "unavailable";

export class Readiness {
  readonly #store: Pick<SessionStore, "check">;
  readonly #clock: Clock;
  readonly #log: Logger;
  #isDraining = false;
  #asked: { at: number; answer: Promise<ReadyStatus> } | null = null;

  constructor(store: Pick<SessionStore, "check">, clock: Clock, log: Logger) {
    this.#store = store;
    this.#clock = clock;
    this.#log = log;
  }

  /** From now on the relay ends what it has, and wants nothing new. */
  drain(): void {
    this.#isDraining = true;
  }

  async status(): Promise<ReadyStatus> {
    if (this.#isDraining) return "draining";
    const now = this.#clock.now();
    if (this.#asked === null || now - this.#asked.at >= FRESH_MS) {
      this.#asked = { at: now, answer: this.#ask() };
    }
    return this.#asked.answer;
  }

  async #ask(): Promise<ReadyStatus> {
    try {
      return (await this.#store.check()) === "full" ? "degraded" : "ready";
    } catch (error) {
      this.#log.error({ err: error }, "the store does not answer");
      return "unavailable";
    }
  }
}
