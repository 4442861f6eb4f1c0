/** Last use of a robot and its keys: immediate in memory, once a minute in the store. */
import type { Clock } from "../platform/time/clock.ts";
import type { RobotStore, StoredRobot } from "../store/robot-store.ts";
import type { KeyRing } from "./access/key-ring.ts";
import { limits } from "../platform/limits/limits.ts";

export interface RobotUseParts {
  store: Pick<RobotStore, "touch">;
  clock: Clock;
  keys: Pick<KeyRing, "dueUses" | "usesNoted">;
}

export class RobotUse {
  readonly #robot: string;
  readonly #parts: RobotUseParts;
  #lastAt: number;
  /** last use that is stored */
  #notedAt: number;

  constructor({ id, lastUsedAt }: StoredRobot, parts: RobotUseParts) {
    this.#robot = id;
    this.#parts = parts;
    this.#lastAt = lastUsedAt;
    this.#notedAt = lastUsedAt;
  }

  get lastAt(): number {
    return this.#lastAt;
  }

  /** Records a use. */
  used(): void {
    this.#lastAt = Math.max(this.#lastAt, this.#parts.clock.now());
  }

  /** Whether a use is due to be stored. */
  get isDue(): boolean {
    const isLong = this.#lastAt - this.#notedAt >= limits.touchMs;
    return isLong || this.#parts.keys.dueUses().length > 0;
  }

  /** Whether the store may soon treat the robot as expired although it is in use. */
  get isUrgent(): boolean {
    const isOld =
      this.#parts.clock.now() - this.#notedAt >= limits.robotIdleMs - 2 * limits.touchMs;
    return isOld && this.#lastAt > this.#notedAt;
  }

  /** Stores the latest uses. */
  async note(): Promise<void> {
    const { store, keys } = this.#parts;
    const uses = keys.dueUses();
    const lastAt = this.#lastAt;
    await store.touch(this.#robot, lastAt, uses);
    this.#notedAt = lastAt;
    keys.usesNoted(uses);
  }
}
