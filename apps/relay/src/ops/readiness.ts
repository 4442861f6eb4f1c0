/**
 * Readiness of the relay: the store responds and no shutdown was requested.
 *
 * A full disk makes the relay `degraded`, not unready. Robots and scripts still read and move. A
 * load balancer that removes the relay would stop that too.
 */
import type { Logger } from "pino";
import type { Clock } from "../platform/time/clock.ts";
import type { RobotStore } from "../store/robot-store.ts";

/** A check costs a commit, so its result is reused for this time. */
const FRESH_MS = 2_000;

export type ReadyStatus = "ready" | "degraded" | "draining" | "unavailable";

export class Readiness {
  readonly #store: Pick<RobotStore, "check">;
  readonly #clock: Clock;
  readonly #log: Logger;
  #isDraining = false;
  #lastCheck: { at: number; status: Promise<ReadyStatus> } | null = null;

  constructor(store: Pick<RobotStore, "check">, clock: Clock, log: Logger) {
    this.#store = store;
    this.#clock = clock;
    this.#log = log;
  }

  /** Reports `draining` from now on. */
  drain(): void {
    this.#isDraining = true;
  }

  async status(): Promise<ReadyStatus> {
    if (this.#isDraining) return "draining";
    const now = this.#clock.now();
    if (this.#lastCheck === null || now - this.#lastCheck.at >= FRESH_MS) {
      this.#lastCheck = { at: now, status: this.#check() };
    }
    return this.#lastCheck.status;
  }

  async #check(): Promise<ReadyStatus> {
    try {
      return (await this.#store.check()) === "full" ? "degraded" : "ready";
    } catch (error) {
      this.#log.error({ err: error }, "the store is unavailable");
      return "unavailable";
    }
  }
}
