/**
 * A list of conditions compiled to flat tables, which are evaluated without allocation. Programs
 * and guarded motions both use it, so that they decide on the same tick.
 */
import { sensorNames, type UntilCondition } from "@corridor/protocol";

const RIGHT = sensorNames.indexOf("right");
const GOAL = -1;
const comparators = [">", "<", ">=", "<="];

export class CompiledConditions {
  readonly #count: number;
  /** index of the sensor; -1 for a goal */
  readonly #sensors: Int32Array;
  /** index in `comparators` */
  readonly #comparators: Uint8Array;
  readonly #numbers: Float64Array;
  /** 1 if the right reading is added to the number */
  readonly #addsRight: Uint8Array;

  constructor(conditions: readonly UntilCondition[]) {
    const comparisons = conditions.map((each) => ("goal" in each ? null : each));
    this.#count = conditions.length;
    this.#sensors = Int32Array.from(comparisons, (each) =>
      each === null ? GOAL : sensorNames.indexOf(each.sensor),
    );
    this.#comparators = Uint8Array.from(comparisons, (each) =>
      each === null ? 0 : comparators.indexOf(each.is),
    );
    this.#numbers = Float64Array.from(comparisons, (each) => {
      if (each === null) return 0;
      return each.than === "right" ? each.plus : each.than;
    });
    this.#addsRight = Uint8Array.from(comparisons, (each) => (each?.than === "right" ? 1 : 0));
  }

  /**
   * Finds the first condition that is true.
   * @param readings front, right, back, left in units
   * @param isInGoal whether the whole robot stands in a goal cell
   * @returns its index, or -1 if none is true
   */
  firstTrue(readings: Float64Array, isInGoal = false): number {
    for (let i = 0; i < this.#count; i++) {
      const sensor = this.#sensors[i] ?? 0;
      if (sensor === GOAL) {
        if (isInGoal) return i;
        continue;
      }
      const number = this.#numbers[i] ?? 0;
      const limit = this.#addsRight[i] === 1 ? (readings[RIGHT] ?? 0) + number : number;
      if (isTrue(this.#comparators[i] ?? 0, readings[sensor] ?? 0, limit)) return i;
    }
    return -1;
  }
}

function isTrue(comparator: number, reading: number, limit: number): boolean {
  if (comparator === 0) return reading > limit;
  if (comparator === 1) return reading < limit;
  return comparator === 2 ? reading >= limit : reading <= limit;
}
