/** Which scripts use a robot, as its page shows them; told at most once a second. */
import type { Drivers } from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import { limits } from "./limits.ts";

export class DriverRoster {
  readonly #clock: Clock;
  readonly #tell: (drivers: Drivers) => void;
  #connected = 0;
  #client: string | null = null;
  #heardAt: number | null = null;
  #cancelTimer: (() => void) | null = null;
  #isNews = false;

  constructor(clock: Clock, tell: (drivers: Drivers) => void) {
    this.#clock = clock;
    this.#tell = tell;
  }

  /** A script was heard. @param client such as "Python" */
  heard(client: string): void {
    this.#client = client;
    this.#heardAt = this.#clock.now();
    this.#changed();
  }

  /** A script's socket was opened (1) or closed (-1). */
  connected(change: 1 | -1): void {
    this.#connected += change;
    this.#changed();
  }

  now(): Drivers {
    const silentMs = this.#heardAt === null ? null : Math.max(0, this.#clock.now() - this.#heardAt);
    return { connected: this.#connected, client: this.#client, silentMs };
  }

  close(): void {
    this.#cancelTimer?.();
    this.#cancelTimer = null;
  }

  #changed(): void {
    this.#isNews = true;
    if (this.#cancelTimer === null) this.#flush();
  }

  #flush(): void {
    this.#isNews = false;
    this.#tell(this.now());
    this.#cancelTimer = this.#clock.after(limits.driversIntervalMs, () => {
      this.#cancelTimer = null;
      if (this.#isNews) this.#flush();
    });
  }
}
