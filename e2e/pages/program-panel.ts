/** Page object of the dropdown editor. Lines are counted from 1, as on their badges. */
import type { Locator, Page } from "playwright/test";

export class ProgramPanel {
  readonly region: Locator;
  readonly #page: Page;

  constructor(page: Page) {
    this.#page = page;
    this.region = page.getByRole("region", { name: "Program" });
  }

  /** All lines from the top, excluding "otherwise". */
  get lines(): Locator {
    return this.region.getByRole("listitem");
  }

  /** One line. Its accessible name is its sentence and its truth value. */
  line(number: number): Locator {
    return this.lines.nth(number - 1);
  }

  /** The note below the running line. */
  get runningLineNote(): Locator {
    return this.region.locator("[data-displayed]");
  }

  condition(line: number): Locator {
    return this.region.getByRole("combobox", { name: `Line ${line}, condition` });
  }

  number(line: number): Locator {
    return this.region.getByRole("textbox", { name: `Line ${line}, distance in cm` });
  }

  action(line: number): Locator {
    return this.region.getByRole("combobox", { name: `Line ${line}, action` });
  }

  get otherwise(): Locator {
    return this.region.getByRole("combobox", { name: "action", exact: true });
  }

  get name(): Locator {
    return this.region.getByRole("textbox", { name: "Name of the program" });
  }

  /** A button of the panel: Add line, Undo, Redo, "Move line 2 up", "Delete line 1". */
  button(name: string): Locator {
    return this.region.getByRole("button", { name, exact: true });
  }

  /** Adds a line and selects its values. */
  async addLine(condition: string, number: string, action: string): Promise<void> {
    const line = (await this.lines.count()) + 1;
    await this.button("Add line").click();
    await this.condition(line).selectOption(condition);
    await this.number(line).fill(number);
    await this.action(line).selectOption(action);
  }

  /** Deletes every line. */
  async deleteAllLines(): Promise<void> {
    for (let left = await this.lines.count(); left > 0; left--) {
      await this.button("Delete line 1").click();
    }
  }

  /** Names the program, so that it becomes the user's own and stays when the maze changes. */
  async nameAsOwn(): Promise<void> {
    await this.name.fill("Mine");
    await this.name.press("Enter");
  }

  /** Loads a ready-made algorithm by its name. */
  async loadAlgorithm(name: string): Promise<void> {
    await this.button("Show an algorithm").click();
    await this.#page
      .getByRole("dialog", { name: "Show an algorithm" })
      .getByRole("button", { name: new RegExp(`^${name}`) })
      .click();
  }
}
