/**
 * The statistics of a micromouse, counted in cells. A run begins when the mouse leaves cell (0, 0),
 * and ends in the goal. Returning to (0, 0) ends it without a result.
 */

/** Score of a mouse that has not reached the goal. */
const UNSOLVED = 2000;
const RESET_PENALTY = 15;
/** Precision of decimal numbers in responses, in digits. */
const DIGITS = 6;

type Quantity = "distance" | "turns" | "effective-distance";
type Counts = Record<Quantity, number>;

const STAT = /^(total|best-run|current-run)-(distance|turns|effective-distance)$/;

export type StatName = `${"total" | "best-run" | "current-run"}-${Quantity}` | "score";

export function isStatName(name: string): name is StatName {
  return name === "score" || STAT.test(name);
}

export class Score {
  readonly #total = noCounts();
  #current = noCounts();
  /** null: the goal was not reached */
  #best: Counts | null = null;
  #isRunning = false;
  /** effective distance that the next run begins with */
  #penalty = 0;

  /** The mouse leaves (0, 0). */
  begin(): void {
    this.#current = { ...noCounts(), "effective-distance": this.#penalty };
    this.#total["effective-distance"] += this.#penalty;
    this.#penalty = 0;
    this.#isRunning = true;
  }

  /** The mouse drives straight ahead. Beyond two cells it is fast: they count half. */
  addMove(cells: number): void {
    const effective = cells > 2 ? cells / 2 + 1 : cells;
    this.#add("distance", cells);
    this.#add("effective-distance", effective);
  }

  addTurn(): void {
    this.#add("turns", 1);
  }

  /** The mouse stands in the goal. */
  finish(): void {
    this.#isRunning = false;
    if (this.#best === null || costOf(this.#current) < costOf(this.#best)) {
      this.#best = { ...this.#current };
    }
  }

  /** The mouse is back in (0, 0). */
  abandon(): void {
    this.#isRunning = false;
  }

  /** The mouse was carried back to the start. */
  penalize(): void {
    this.#penalty = RESET_PENALTY;
    this.abandon();
  }

  /** The response of `getStat`; -1 for a number that does not exist yet. */
  get(name: StatName): string {
    const [, of, quantity] = STAT.exec(name) ?? [];
    if (of === undefined || quantity === undefined) return decimal(this.#score);
    const counts = { total: this.#total, "best-run": this.#best, "current-run": this.#current };
    const value = counts[of as keyof typeof counts]?.[quantity as Quantity] ?? -1;
    return quantity === "effective-distance" ? decimal(value) : String(Math.floor(value));
  }

  get #score(): number {
    return this.#best === null ? UNSOLVED : costOf(this.#best) + 0.1 * costOf(this.#total);
  }

  #add(quantity: Quantity, amount: number): void {
    this.#total[quantity] += amount;
    if (this.#isRunning) this.#current[quantity] += amount;
  }
}

function noCounts(): Counts {
  return { distance: 0, turns: 0, "effective-distance": 0 };
}

function costOf(counts: Counts): number {
  return counts.turns + counts["effective-distance"];
}

function decimal(value: number): string {
  return String(Number(value.toPrecision(DIGITS)));
}
