/**
 * The readings that reach a line: those for which every line above is false. Exact, without
 * sampling.
 *
 * A line that is false gives one closed bound, on a reading or on the difference of left and right:
 * "right > 60" false is right <= 60, "left > right + 1" false is left - right <= 1. So the readings
 * that reach a line are a system of difference constraints over left, right and 0, and two
 * intervals for front and back. Only the tightest bound of each kind matters, and three nodes have
 * few cycles: each query takes a constant number of comparisons.
 * @see Cormen, Leiserson, Rivest, Stein: Introduction to Algorithms, difference constraints
 *
 * All sums are sums that the program computes as well: a right reading plus the number of a line.
 */
import { numberOf, type Condition } from "@corridor/program";

/** The range of all four sensors, in units. */
export interface ReadingRange {
  min: number;
  max: number;
}

/** The quantity of a condition: a reading, or left minus right. */
export type Quantity = Condition["sensor"] | "difference";

/** @returns the quantity that a condition compares with its number */
export function quantityOf(condition: Condition): Quantity {
  return condition.than === "right" ? "difference" : condition.sensor;
}

type Bounds = Record<Quantity, number>;

export class ReachingReadings {
  readonly #low: Bounds;
  readonly #high: Bounds;

  constructor({ min, max }: ReadingRange) {
    this.#low = { front: min, right: min, back: min, left: min, difference: -Infinity };
    this.#high = { front: max, right: max, back: max, left: max, difference: Infinity };
  }

  /** Excludes the readings for which a line decides. */
  pass(condition: Condition): void {
    const quantity = quantityOf(condition);
    const number = numberOf(condition);
    if (condition.is === ">") this.#high[quantity] = Math.min(this.#high[quantity], number);
    else this.#low[quantity] = Math.max(this.#low[quantity], number);
  }

  /** Whether the passed lines decide for all readings. */
  get isEmpty(): boolean {
    const low = this.#low;
    const high = this.#high;
    return (
      low.front > high.front ||
      low.back > high.back ||
      low.right > high.right ||
      low.left > high.left ||
      low.difference > high.difference ||
      low.left > high.right + high.difference ||
      low.right + low.difference > high.left
    );
  }

  /** Whether a condition is true for any remaining reading. */
  allows(condition: Condition): boolean {
    if (this.isEmpty) return false;
    const quantity = quantityOf(condition);
    const number = numberOf(condition);
    const low = this.#low;
    const high = this.#high;
    if (condition.is === ">") {
      if (number >= high[quantity]) return false;
      if (quantity === "left") return number < high.right + high.difference;
      if (quantity === "right") return number + low.difference < high.left;
      return quantity !== "difference" || low.right + number < high.left;
    }
    if (number <= low[quantity]) return false;
    if (quantity === "left") return number > low.right + low.difference;
    if (quantity === "right") return number + high.difference > low.left;
    return quantity !== "difference" || high.right + number > low.left;
  }

  /** The largest remaining reading of a sensor; undefined if none remains. */
  max(sensor: Condition["sensor"]): number {
    const high = this.#high;
    if (sensor === "left") return Math.min(high.left, high.right + high.difference);
    if (sensor === "right") return Math.min(high.right, high.left - this.#low.difference);
    return high[sensor];
  }

  /** The smallest remaining reading of a sensor; undefined if none remains. */
  min(sensor: Condition["sensor"]): number {
    const low = this.#low;
    if (sensor === "left") return Math.max(low.left, low.right + low.difference);
    if (sensor === "right") return Math.max(low.right, low.left - this.#high.difference);
    return low[sensor];
  }
}
