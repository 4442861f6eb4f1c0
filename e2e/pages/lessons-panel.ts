/** Page object of the lessons: the lesson path, the mission card and the line above the maze. */
import { expect, type Locator, type Page } from "playwright/test";

export class LessonsPanel {
  readonly #page: Page;
  readonly invitation: Locator;
  readonly card: Locator;
  readonly path: Locator;
  /** the card's note on the attempt */
  readonly outcome: Locator;

  constructor(page: Page) {
    this.#page = page;
    this.invitation = page.getByRole("region", { name: "Lessons" });
    this.card = page.getByRole("region", { name: "Mission" });
    this.path = page.getByRole("dialog", { name: "Lessons" });
    this.outcome = this.card.getByRole("note");
  }

  /** Opens a mission from the lesson path by its number, and waits until it is displayed. */
  async openMission(number: number): Promise<void> {
    await this.openPath();
    await this.path.getByRole("button", { name: new RegExp(`^${number}\\. `) }).click();
    await this.expectMission(number);
  }

  async openPath(): Promise<void> {
    await this.#page.getByRole("banner").getByRole("button", { name: "Lessons" }).click();
    await expect(this.path).toBeVisible();
  }

  /** On a phone, the path is in the "More" dialog, and only the card shows the mission's number. */
  async openMissionOnPhone(number: number): Promise<void> {
    await this.#page.getByRole("banner").getByRole("button", { name: "More" }).click();
    const more = this.#page.getByRole("dialog", { name: "More" });
    await more.getByRole("button", { name: "Lessons" }).click();
    await this.path.getByRole("button", { name: new RegExp(`^${number}\\. `) }).click();
    await expect(this.path).toBeHidden();
    await expect(this.card).toBeVisible();
  }

  async expectMission(number: number): Promise<void> {
    await expect(this.card).toContainText(`Mission ${number} of 14`);
  }

  button(name: string | RegExp): Locator {
    return this.card.getByRole("button", { name });
  }

  get hints(): Locator {
    return this.card.getByText(/^Hint \d/);
  }
}
