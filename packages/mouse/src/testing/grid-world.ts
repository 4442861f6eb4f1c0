/**
 * The simulator mms without a robot: a mouse on a grid with thin walls, written from the description of
 * the protocol and independent of the code that drives the robot.
 */

/** Steps to the north, east, south and west, in half steps. */
const steps = [
  [0, 1],
  [1, 0],
  [0, -1],
  [-1, 0],
] as const;
const turned: Record<string, number> = {
  turnRight: 2,
  turnRight90: 2,
  turnLeft: 6,
  turnLeft90: 6,
  turnRight45: 1,
  turnLeft45: 7,
};
const looks = [
  "Front",
  "FrontRight",
  "Right",
  "BackRight",
  "Back",
  "BackLeft",
  "Left",
  "FrontLeft",
];
const zero = { distance: 0, turns: 0, effective: 0 };

export class GridWorld {
  readonly columns: number;
  readonly rows: number;
  readonly #isWall: (x: number, y: number, side: number) => boolean;
  #x = 1;
  #y = 1;
  #heading = 0;
  #total = { ...zero };
  #run = { ...zero };
  #best: typeof zero | null = null;
  #isInRun = false;
  #penalty = 0;

  /** @param isWall at a side (0 north, clockwise) of cell (x, y) */
  constructor(
    columns: number,
    rows: number,
    isWall: (x: number, y: number, side: number) => boolean,
  ) {
    this.columns = columns;
    this.rows = rows;
    this.#isWall = isWall;
  }

  /** @returns the response, or null if there is none */
  answer(line: string): string | null {
    const words = line.split(" ").filter(Boolean);
    const [name = "", argument] = words;
    const isInteger = argument !== undefined && /^[+-]?\d+$/.test(argument);
    const steps = argument === undefined ? 1 : isInteger ? Number(argument) : 0;
    if (words.length > 2) return null;
    if (name === "getStat") return this.#stat(argument ?? "");
    const look = looks.findIndex((each) => name === `wall${each}`);
    if (look >= 0) return String(this.#free(look) < Math.max(1, steps));
    if (name === "moveForward") return this.#move(2 * steps);
    if (name === "moveForwardHalf") return this.#move(steps);
    if (argument !== undefined) return null;
    const turn = turned[name];
    if (turn !== undefined) {
      this.#heading = (this.#heading + turn) % 8;
      this.#add({ ...zero, turns: 1 });
      this.#arrive();
      return "ack";
    }
    if (name === "mazeWidth") return String(this.columns);
    if (name === "mazeHeight") return String(this.rows);
    if (name === "wasReset") return "false";
    if (name !== "ackReset") return null;
    [this.#x, this.#y, this.#heading] = [1, 1, 0];
    this.#penalty = 15;
    this.#isInRun = false;
    return "ack";
  }

  /** Half steps until a wall. */
  #free(look: number): number {
    const [dx, dy] = steps[((this.#heading + look) % 8) / 2] ?? [0, 0];
    // Diagonally, corners are in the way.
    if (dx === 0 && dy === 0) return 0;
    let free = 0;
    let [x, y] = [this.#x, this.#y];
    while (!this.#blocks(x, y, dx, dy)) {
      free += 1;
      x += dx;
      y += dy;
    }
    return free;
  }

  /** Whether a wall, or a post, is half a step ahead of a place. */
  #blocks(x: number, y: number, dx: number, dy: number): boolean {
    if (x % 2 === 0) return dy !== 0;
    if (y % 2 === 0) return dx !== 0;
    const side = steps.findIndex(([sx, sy]) => sx === dx && sy === dy);
    return this.#isWall((x - 1) / 2, (y - 1) / 2, side);
  }

  #move(wanted: number): string {
    const length = Math.min(wanted, this.#free(0));
    if (length < 1) return "crash";
    if (this.#cell() === "0 0") {
      this.#run = { ...zero, effective: this.#penalty };
      this.#total.effective += this.#penalty;
      this.#penalty = 0;
      this.#isInRun = true;
    }
    const cells = length / 2;
    this.#add({ distance: cells, turns: 0, effective: cells <= 2 ? cells : 2 + (cells - 2) / 2 });
    const [dx, dy] = steps[this.#heading / 2] ?? [0, 0];
    this.#x += dx * length;
    this.#y += dy * length;
    this.#arrive();
    return length === wanted ? "ack" : "crash";
  }

  #arrive(): void {
    const middles = (size: number): number[] => [Math.floor((size - 1) / 2), Math.floor(size / 2)];
    const goals = middles(this.columns).flatMap((x) => middles(this.rows).map((y) => `${x} ${y}`));
    if (goals.includes(this.#cell())) {
      this.#isInRun = false;
      const cost = this.#run.turns + this.#run.effective;
      if (this.#best === null || cost < this.#best.turns + this.#best.effective) {
        this.#best = { ...this.#run };
      }
    } else if (this.#cell() === "0 0") this.#isInRun = false;
  }

  #add(more: typeof zero): void {
    for (const counts of this.#isInRun ? [this.#total, this.#run] : [this.#total]) {
      counts.distance += more.distance;
      counts.turns += more.turns;
      counts.effective += more.effective;
    }
  }

  #cell(): string {
    return `${Math.floor(this.#x / 2)} ${Math.floor(this.#y / 2)}`;
  }

  #stat(name: string): string | null {
    const best = this.#best;
    const total = this.#total;
    const values: Record<string, number> = {
      "total-distance": Math.floor(total.distance),
      "total-turns": total.turns,
      "total-effective-distance": total.effective,
      "current-run-distance": Math.floor(this.#run.distance),
      "current-run-turns": this.#run.turns,
      "current-run-effective-distance": this.#run.effective,
      "best-run-distance": best === null ? -1 : Math.floor(best.distance),
      "best-run-turns": best === null ? -1 : best.turns,
      "best-run-effective-distance": best === null ? -1 : best.effective,
      score:
        best === null ? 2000 : best.turns + best.effective + (total.turns + total.effective) / 10,
    };
    const value = values[name];
    return value === undefined ? null : String(Number(value.toPrecision(6)));
  }
}
