/** Page object of the lesson editor on `/teach`. */
import { expect, type Page } from "playwright/test";
import { CorridorPage } from "./corridor-page.ts";
import { MazeGrid } from "./maze-grid.ts";

export class LessonEditor {
  readonly page: Page;
  readonly name;
  readonly status;
  readonly tasks;
  readonly maze;

  constructor(page: Page) {
    this.page = page;
    this.name = page.getByRole("banner").getByRole("heading", { level: 2 });
    this.status = page.getByRole("banner").getByText("Saved", { exact: true });
    this.tasks = page
      .getByRole("navigation", { name: "Parts of the lesson" })
      .getByRole("listitem");
    this.maze = new MazeGrid(page);
  }

  /** Opens a task in the form. @param number from 1 */
  async openTask(number: number): Promise<void> {
    await this.tasks
      .nth(number - 1)
      .getByRole("button")
      .first()
      .click();
  }

  field(name: string) {
    return this.page.getByRole("textbox", { name, exact: true });
  }

  button(name: string) {
    return this.page.getByRole("button", { name, exact: true });
  }

  async chooseInMenu(menu: string, item: string): Promise<void> {
    await this.button(menu).click();
    await this.button(item).click();
  }

  /** Begins with an empty maze of 11 by 7 squares, and opens its task. */
  async beginEmpty(): Promise<void> {
    await this.page.goto("/teach");
    await this.page.getByRole("link", { name: /^Make a lesson/ }).click();
    await this.page.getByRole("button", { name: /^An empty maze/ }).click();
    await expect(this.maze.grid).toBeVisible();
    await this.openTask(1);
  }

  /** Solves the empty maze in the trial that is open, with one line. */
  async solveEmpty(): Promise<void> {
    const student = new CorridorPage(this.page);
    await student.program.addLine("front <", "60", "left 90");
    await student.speed.selectOption("max");
    await student.run.click();
  }
}
