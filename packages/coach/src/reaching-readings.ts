/**
 * Which readings reach a line: those for which every line above is false. Exact, without trying values.
 *
 * A line that is false gives one closed bound, on a reading or on the difference of left and right:
 * "right > 60" false is right <= 60, "left > right + 1" false is left - right <= 1. So the readings
 * that reach a line are a system of difference constraints over left, right and 0, beside two plain
 * intervals for front and back. Only the tightest bound of each kind matters, and over three nodes
 * there are few ways around: every question costs a fixed number of comparisons, whatever the program.
 * @see Cormen, Leiserson, Rivest, Stein: Introduction to Algorithms, difference constraints
 *
 * Sums are those that the program computes itself, a right reading plus the number of a line.
 */
import { numberOf, type Condition } from "@corridor/program";

/** All readings that there are: each of the four sensors from `min` to `max`, in units. */
export interface ReadingRange {
  min: number;
  max: number;
}

/** What a condition bounds: a reading, or left minus right. */
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

  /** Goes below a line: what it decides for does not reach the next one. */
  pass(condition: Condition): void {
    const quantity = quantityOf(condition);
    const number = numberOf(condition);
    if (condition.is === ">") this.#high[quantity] = Math.min(this.#high[quantity], number);
    else this.#low[quantity] = Math.max(this.#low[quantity], number);
  }

  /** Whether no reading is left: the lines passed so far decide for all of them. */
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

  /** Whether a condition is true for some reading that is left. */
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

  /** The largest reading of a sensor that is left; meaningless when none is. */
  max(sensor: Condition["sensor"]): number {
    const high = this.#high;
    if (sensor === "left") return Math.min(high.left, high.right + high.difference);
    if (sensor === "right") return Math.min(high.right, high.left - this.#low.difference);
    return high[sensor];
  }

  /** The smallest reading of a sensor that is left; meaningless when none is. */
  min(sensor: Condition["sensor"]): number {
    const low = this.#low;
    if (sensor === "left") return Math.max(low.left, low.right + low.difference);
    if (sensor === "right") return Math.max(low.right, low.left - this.#high.difference);
    return low[sensor];
  }
}
