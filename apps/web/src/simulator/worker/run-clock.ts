/**
 * Converts real time to ticks at the chosen speed. "max" runs as many as fit into a share of the
 * time. Speed applies to programs, scripts and replays. While a user drives or a script is awaited,
 * a second always takes a second.
 */
import { FixedTimestep } from "@corridor/simulation";
import type { Speed } from "../protocol/worker-messages.ts";

/** At speed "max": ticks between two reads of the clock, and the share of time that may be used. */
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

  /** Starts the clock, with a tick at once; earlier time does not count. */
  start(): void {
    this.#timestep.start();
    this.#lastAt = this.#now();
  }

  /**
   * Runs the ticks for the time since the last call.
   * @param flow standing: none; real-time: as many as in real time; at-speed: at the chosen speed
   * @param runTicks runs this many ticks; returns false if the clock stops
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
