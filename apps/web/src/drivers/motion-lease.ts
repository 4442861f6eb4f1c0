/**
 * How long the robot goes on with a motion that has no end of its own. A script that fell silent, or a
 * line that broke, must not leave it driving: it stops when the lease of the motion runs out.
 */
import type { DeliveredCommand } from "@corridor/protocol";

/** Of `forward` and `reverse`: renewed whenever their sender is heard. */
const HEARD_MS = 3_000;
/** Of a drive that asks for none: renewed by the next drive alone. */
const DRIVE_MS = 500;

/** Whether it is a velocity, of which only the newest value counts: a drive without a time. */
export function isRegister({ command }: DeliveredCommand): boolean {
  return command.action === "drive" && command.milliseconds === undefined;
}

export class MotionLease {
  readonly #driver: string;
  readonly #isRenewable: boolean;
  readonly #milliseconds: number;
  #renewedAt: number;

  private constructor(driver: string, milliseconds: number, isRenewable: boolean, now: number) {
    this.#driver = driver;
    this.#milliseconds = milliseconds;
    this.#isRenewable = isRenewable;
    this.#renewedAt = now;
  }

  /** The lease of a command that starts now; null for one that ends by itself. */
  static of(delivery: DeliveredCommand, now: number): MotionLease | null {
    const { command, driver, lease } = delivery;
    if (command.action === "forward" || command.action === "reverse") {
      return new MotionLease(driver, HEARD_MS, true, now);
    }
    return isRegister(delivery) ? new MotionLease(driver, lease ?? DRIVE_MS, false, now) : null;
  }

  /** A script was heard. @param at when */
  heard(driver: string, at: number): void {
    if (this.#isRenewable && driver === this.#driver) {
      this.#renewedAt = Math.max(this.#renewedAt, at);
    }
  }

  isOver(now: number): boolean {
    return now - this.#renewedAt >= this.#milliseconds;
  }
}
