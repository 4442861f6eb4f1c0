/** Lines on standard error, or in a browser's console, that explain to a script why it waits. */
import { waitingReason, type Obstacle } from "@corridor/protocol";
import type { ConnectionStatus } from "./connection.ts";
import type { Clock } from "./platform.ts";

type Warn = (text: string) => void;

/** Time without progress of a command after which the reason is printed. */
const SILENCE_MS = 3_000;
/** Time without a connection. A network that blocks WebSockets takes 4 s until the fallback. */
const UNREACHABLE_MS = 5_000;

/** Calls once after a time in which a condition was true throughout. */
class Alarm {
  readonly #clock: Clock;
  #cancel: (() => void) | null = null;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** Starts, unless it has been started since the last `reset`. */
  start(ms: number, call: () => void): void {
    this.#cancel ??= this.#clock.after(ms, call);
  }

  reset(): void {
    this.#cancel?.();
    this.#cancel = null;
  }
}

/** Prints once why a command does not continue: the page is closed, paused or asleep. */
export class SilentRobotNotice {
  readonly #alarm: Alarm;
  readonly #warn: Warn;
  #isWaiting = false;
  #obstacle: Obstacle | null = null;

  constructor(clock: Clock, warn: Warn) {
    this.#alarm = new Alarm(clock);
    this.#warn = warn;
  }

  /** @param isWaiting whether a command has not ended */
  waits(isWaiting: boolean): void {
    this.#isWaiting = isWaiting;
    this.#update();
  }

  /** @param obstacle why the robot does not continue; null: it does */
  found(obstacle: Obstacle | null): void {
    this.#obstacle = obstacle;
    this.#update();
  }

  #update(): void {
    if (!this.#isWaiting || this.#obstacle === null) return this.#alarm.reset();
    this.#alarm.start(SILENCE_MS, () => {
      if (this.#obstacle !== null) this.#warn(waitingReason(this.#obstacle));
    });
  }
}

/** Prints once that the robot's host does not respond, until it does again. */
export class UnreachableNotice {
  readonly #alarm: Alarm;
  readonly #print: () => void;
  #isPrinted = false;
  #wasConnected = false;

  constructor(clock: Clock, warn: Warn, origin: string) {
    this.#alarm = new Alarm(clock);
    this.#print = () => {
      if (!this.#isPrinted) warn(`The robot's host does not respond at ${origin}. Retrying.`);
      this.#isPrinted = true;
    };
  }

  changed({ kind }: ConnectionStatus): void {
    switch (kind) {
      case "connecting":
        return this.#alarm.start(UNREACHABLE_MS, this.#print);
      case "lost":
        // A connection that was lost usually returns soon.
        if (!this.#wasConnected) this.#print();
        this.#wasConnected = false;
        return;
      case "connected":
        this.#wasConnected = true;
        this.#isPrinted = false;
        return this.#alarm.reset();
      case "over":
        return this.close();
    }
  }

  close(): void {
    this.#alarm.reset();
  }
}
