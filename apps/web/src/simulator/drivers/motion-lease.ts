/**
 * The lease of a motion without an end of its own. The robot stops when the lease expires, so that
 * a silent script or a broken connection does not leave it driving.
 */
import { isVelocity, LEASE_MS, type DeliveredCommand } from "@corridor/protocol";

/** For `forward`, `reverse` and guarded motions: renewed by every message of their script. */
const FORWARD_MS = 3_000;
/** For a velocity without a lease of its own: renewed only by the next drive. */
const DRIVE_MS = LEASE_MS.default;

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
    const isGuarded = command.until !== undefined;
    if (isGuarded || command.action === "forward" || command.action === "reverse") {
      return new MotionLease(driver, FORWARD_MS, true, now);
    }
    return isVelocity(command) ? new MotionLease(driver, lease ?? DRIVE_MS, false, now) : null;
  }

  /**
   * Renews the lease if it is of this script.
   * @param at time of the script's message
   */
  renew(driver: string, at: number): void {
    if (this.#isRenewable && driver === this.#driver) {
      this.#renewedAt = Math.max(this.#renewedAt, at);
    }
  }

  isOver(now: number): boolean {
    return now - this.#renewedAt >= this.#milliseconds;
  }
}
