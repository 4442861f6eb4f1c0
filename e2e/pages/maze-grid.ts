/** Page object of the maze on the stage, for pointer, touch and the keyboard cursor. */
import { expect, type Locator, type Page } from "playwright/test";

/** A square of the maze, counted from 0. */
export interface Square {
  column: number;
  row: number;
}

export class MazeGrid {
  readonly #page: Page;
  readonly grid: Locator;

  constructor(page: Page) {
    this.#page = page;
    this.grid = page.getByRole("grid", { name: "Maze" });
  }

  /** A button of the strip above the maze: Undo, Redo, Clear maze, Resize. */
  button(name: string): Locator {
    return this.#page
      .getByRole("region", { name: "Maze" })
      .getByRole("button", { name, exact: true });
  }

  tool(name: "Blocks" | "Start" | "Goal" | "Measure"): Locator {
    return this.#page.getByRole("group", { name: "Tool" }).getByRole("radio", { name });
  }

  /** The announcement after a press on a square: its new state, or the measured distances. */
  get announcement(): Locator {
    return this.#page.locator("#spoken");
  }

  /** Clicks the centre of a square. */
  async click(square: Square): Promise<void> {
    await this.grid.click({ position: await this.#centreOf(square) });
  }

  /** Taps the centre of a square. */
  async tap(square: Square): Promise<void> {
    await this.#waitForFinalSize();
    await this.grid.tap({ position: await this.#centreOf(square) });
  }

  /** Presses on the first square, moves over all others, and releases on the last. */
  async drag(squares: readonly Square[]): Promise<void> {
    const box = await this.grid.boundingBox();
    if (box === null) throw new Error("the maze is not on the screen");
    for (const [at, square] of squares.entries()) {
      const { x, y } = await this.#centreOf(square);
      await this.#page.mouse.move(box.x + x, box.y + y);
      if (at === 0) await this.#page.mouse.down();
    }
    await this.#page.mouse.up();
  }

  /** Moves the keyboard cursor to a square. @returns the focused square */
  async moveCursorTo({ column, row }: Square): Promise<Locator> {
    await this.cursor.focus();
    const from = await this.cursor.evaluate((cell) => ({
      column: Number(cell.ariaColIndex) - 1,
      row: Number(cell.parentElement?.ariaRowIndex) - 1,
    }));
    await this.#press("ArrowLeft", from.column - column);
    await this.#press("ArrowRight", column - from.column);
    await this.#press("ArrowUp", from.row - row);
    await this.#press("ArrowDown", row - from.row);
    return this.cursor;
  }

  /** The square with the keyboard cursor, which is the only square in the Tab order. */
  get cursor(): Locator {
    return this.grid.locator('[tabindex="0"]');
  }

  /** Expects the name of a square, such as "block" or "open, goal". */
  async expectSquare(square: Square, description: string): Promise<void> {
    const name = `row ${square.row + 1}, column ${square.column + 1}, ${description}`;
    await expect(await this.moveCursorTo(square)).toHaveAccessibleName(name);
  }

  /** Presses a key `times` times, or not at all if `times` is negative. */
  async #press(key: string, times: number): Promise<void> {
    for (let press = 0; press < times; press++) await this.#page.keyboard.press(key);
  }

  /** The screen rectangle of the robot, 50 cm wide, at a position in cm. */
  async robotBox(x: number, y: number): Promise<{ x: number; y: number; side: number }> {
    const box = await this.grid.boundingBox();
    if (box === null) throw new Error("the maze is not on the screen");
    const scale = box.width / (100 * Number(await this.grid.getAttribute("aria-colcount")));
    return { x: box.x + (x - 25) * scale, y: box.y + (y - 25) * scale, side: 50 * scale };
  }

  /** The screen rectangle of a square. */
  async squareBox({ column, row }: Square): Promise<{ x: number; y: number; side: number }> {
    const { x, y, side } = await this.robotBox(100 * column + 50, 100 * row + 50);
    return { x: x - side / 2, y: y - side / 2, side: 2 * side };
  }

  /**
   * Waits until the maze has its final size: on a phone, switching tabs moves the sheet below it.
   */
  async #waitForFinalSize(): Promise<void> {
    let before = "";
    await expect
      .poll(async () => {
        const now = JSON.stringify(await this.grid.boundingBox());
        const isStill = now === before;
        before = now;
        return isStill;
      })
      .toBe(true);
  }

  async #centreOf({ column, row }: Square): Promise<{ x: number; y: number }> {
    const box = await this.grid.boundingBox();
    if (box === null) throw new Error("the maze is not on the screen");
    const columns = Number(await this.grid.getAttribute("aria-colcount"));
    const rows = Number(await this.grid.getAttribute("aria-rowcount"));
    return {
      x: ((column + 0.5) * box.width) / columns,
      y: ((row + 0.5) * box.height) / rows,
    };
  }
}
