/** Page object of the dashboard, which shows a class to its teacher. */
import { expect, type Locator, type Page } from "playwright/test";

export class DashboardPage {
  readonly page: Page;
  readonly code: Locator;
  readonly cards: Locator;
  /** the sheet of the student whom the teacher watches */
  readonly sheet: Locator;
  /** below the cards; a phone has it in its menu */
  readonly endLesson: Locator;

  constructor(page: Page) {
    this.page = page;
    this.code = page.getByRole("region", { name: "Letters for the board" });
    this.cards = page.getByRole("list").getByRole("button", { name: /attempt/ });
    this.sheet = page.getByRole("complementary");
    this.endLesson = page.getByRole("main").getByRole("button", { name: "End lesson" });
  }

  /** The card of a student. Its name begins with the student and the state. */
  cardOf(name: string): Locator {
    return this.page.getByRole("button", { name: new RegExp(`^${name}, `) });
  }

  async expectState(name: string, state: string): Promise<void> {
    await expect(this.cardOf(name)).toHaveAccessibleName(new RegExp(`^${name}, ${state}, `));
  }

  /** The states of all cards, in their order. */
  async states(): Promise<string[]> {
    return this.cards.evaluateAll((cards) =>
      cards.map((card) => card.getAttribute("aria-label")?.split(", ")[1] ?? ""),
    );
  }

  /** The letters that the dashboard shows, without the space. */
  async letters(): Promise<string> {
    const text = await this.code.getByText(/^[B-Z]{3} [B-Z]{3}$/).textContent();
    return (text ?? "").replace(" ", "");
  }

  /** Chooses an item of a menu. */
  async choose(menu: string, item: string | RegExp): Promise<void> {
    await this.page.getByRole("button", { name: menu }).click();
    await this.page.getByRole("dialog").getByRole("button", { name: item }).click();
  }

  async watch(name: string): Promise<void> {
    await this.cardOf(name).click();
    await expect(this.sheet.getByRole("heading", { name })).toBeVisible();
  }
}
