/** Page object of the card of a lesson with several tasks. */
import { expect, type Page } from "playwright/test";

/** Drops a lesson onto the page as a file. */
export async function drop(page: Page, document: unknown): Promise<void> {
  const text = typeof document === "string" ? document : JSON.stringify(document);
  const files = await page.evaluateHandle((content) => {
    const data = new DataTransfer();
    data.items.add(new File([content], "lesson.json", { type: "application/json" }));
    return data;
  }, text);
  await page.dispatchEvent("body", "drop", { dataTransfer: files });
}

/** The card of a lesson. */
export class Lesson {
  readonly page: Page;
  readonly card;
  readonly tasks;
  readonly outcome;

  constructor(page: Page) {
    this.page = page;
    this.card = page.getByRole("region", { name: "Lesson", exact: true });
    this.tasks = this.card.getByRole("navigation", { name: "Tasks of this lesson" });
    this.outcome = this.card.getByRole("note");
  }

  task(number: number) {
    return this.tasks.getByRole("button", { name: new RegExp(`^${number} `) });
  }

  async expectTask(number: number): Promise<void> {
    await expect(this.task(number)).toHaveAttribute("aria-current", "step");
  }
}
