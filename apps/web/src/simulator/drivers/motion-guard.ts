/**
 * The conditions of a guarded motion. The robot evaluates them before the first tick of the motion
 * and after every tick, so that a script ends a motion on the same tick as a program would.
 */
import { CompiledConditions } from "@corridor/program";
import type { DeliveredCommand } from "@corridor/protocol";
import type { Run } from "@corridor/recording";

export class MotionGuard {
  readonly #conditions: CompiledConditions;

  private constructor(conditions: CompiledConditions) {
    this.#conditions = conditions;
  }

  /** The guard of a command; null for one without conditions. */
  static of({ command }: DeliveredCommand): MotionGuard | null {
    const { until } = command;
    return until === undefined ? null : new MotionGuard(new CompiledConditions(until));
  }

  /** Whether one of the conditions is true at the end of this tick. */
  isTrue({ readings, isInGoal }: Pick<Run, "readings" | "isInGoal">): boolean {
    return this.#conditions.firstTrue(readings, isInGoal) >= 0;
  }
}
