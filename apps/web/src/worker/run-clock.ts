/**
 * From real time to ticks at the chosen speed. "max" is as many as a share of the time allows. The speed is for
 * programs, scripts and replays: under a hand, and while a robot waits for its script, a second always takes a second.
 */
import { FixedTimestep } from "@corridor/simulation";
import type { Speed } from "./worker-messages.ts";

/** At speed "max", ticks between two looks at the clock, and the share of time that may be used. */
const MAX_SPEED_CHUNK = 240;
const MAX_SPEED_BUDGET_MS = 6;

export class RunClock {
  readonly #now: () => number;
  readonly #timestep = new FixedTimestep();
  #speed: Speed = 1;
  #lastAt = 0;

  /** @param now monotonic milliseconds */
  constructor(now: () => number) {
    this.#now = now;
  }

  set speed(speed: Speed) {
    this.#speed = speed;
    this.#timestep.clear();
  }

  /** Time begins to flow, with a tick at once: what passed until now counts for nothing. */
  start(): void {
    this.#timestep.start();
    this.#lastAt = this.#now();
  }

  /**
   * Asks for the ticks of the time since the last call.
   * @param flow standing: none; real-time: as many as in real time; at-speed: as many as the chosen speed says
   * @param runTicks runs so many. @returns false when time has stopped flowing
   */
  advance(flow: "standing" | "real-time" | "at-speed", runTicks: (count: number) => boolean): void {
    const now = this.#now();
    const elapsed = now - this.#lastAt;
    this.#lastAt = now;
    if (flow === "standing") return;
    const speed = flow === "real-time" ? 1 : this.#speed;
    if (speed !== "max") {
      runTicks(this.#timestep.ticksFor(elapsed, speed));
      return;
    }
    while (this.#now() - now < MAX_SPEED_BUDGET_MS && runTicks(MAX_SPEED_CHUNK));
  }
}
