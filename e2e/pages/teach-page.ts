/** The pages for teachers. */
import { expect, type Locator, type Page } from "playwright/test";

export class TeachPage {
  readonly page: Page;
  readonly lesson: Locator;
  readonly openLesson: Locator;
  readonly lines: Locator;
  readonly rows: Locator;

  constructor(page: Page) {
    this.page = page;
    this.lesson = page.getByRole("textbox", { name: "Link or short link of the lesson" });
    this.openLesson = page.getByRole("button", { name: "Open lesson" });
    this.lines = page.getByRole("textbox", { name: "Links and completion codes" });
    this.rows = page.getByRole("table").locator("tbody tr");
  }

  /** Opens the hand-ins of a lesson. @param link text after # */
  async openHandIns(link: string): Promise<void> {
    await this.page.goto("/teach#hand-ins");
    await this.lesson.fill(link);
    await this.openLesson.click();
    await expect(this.lines).toBeVisible();
  }

  check(): Locator {
    return this.page.getByRole("button", { name: /^Check/ });
  }

  async chooseFiles(files: readonly { name: string; text: string }[]): Promise<void> {
    const chooser = this.page.waitForEvent("filechooser");
    await this.page.getByRole("button", { name: "Choose files" }).click();
    await (
      await chooser
    ).setFiles(
      files.map(({ name, text }) => ({
        name,
        mimeType: "application/json",
        buffer: Buffer.from(text),
      })),
    );
  }

  /** Checks the lines, and waits for the end. */
  async checkLines(lines: readonly string[]): Promise<void> {
    await this.lines.fill(lines.join("\n"));
    await this.check().click();
    await expect(this.page.getByText(/^Checked all/).first()).toBeVisible();
  }
}
