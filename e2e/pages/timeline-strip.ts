/** The timeline of the run, as the pointer and the keyboard find it. */
import { expect, type Locator, type Page } from "playwright/test";

export class TimelineStrip {
  readonly #page: Page;
  readonly #transport: Locator;
  readonly slider: Locator;

  constructor(page: Page, transport: Locator) {
    this.#page = page;
    this.#transport = transport;
    this.slider = transport.getByRole("slider", { name: "Timeline" });
  }

  /** The mark of the shown moment; pictures only, since the slider says it. */
  get playhead(): Locator {
    return this.#transport.locator("[data-playhead]");
  }

  get backToNow(): Locator {
    return this.#transport.getByRole("button", { name: "Back to now" });
  }

  get watch(): Locator {
    return this.#transport.getByRole("button", { name: "Watch" });
  }

  get runFromHere(): Locator {
    return this.#transport.getByRole("button", { name: "Run from here" });
  }

  get oneBack(): Locator {
    return this.#transport.getByRole("button", { name: "One decision back" });
  }

  /** What the clock says besides the time while the past is shown. */
  get inThePast(): Locator {
    return this.#transport.getByText("in the past", { exact: true });
  }

  /** The pictures of what happened, above the ribbon; they have no role, since the slider says it. */
  mark(kind: "bump" | "goal" | "turn" | "edit"): Locator {
    return this.#transport.locator(`[data-kind=${kind}]`);
  }

  /** The times below the ribbon. */
  get axis(): Locator {
    return this.#transport.locator("svg g > g > text");
  }

  get zoomIn(): Locator {
    return this.#transport.getByRole("button", { name: "Zoom the timeline in" });
  }

  get wholeRun(): Locator {
    return this.#transport.getByRole("button", { name: "Whole run" });
  }

  /** The bar that scrolls a part of the run. */
  get visiblePart(): Locator {
    return this.#transport.getByRole("region", { name: "Visible part of the run" });
  }

  /** The numbered mark of a script's command, or of several: "3", "3–7". */
  command(label: string): Locator {
    return this.#transport.locator(`[data-command="${label}"]`);
  }

  /** Presses on the number of a command. */
  async pressCommand(label: string): Promise<void> {
    const box = await this.command(label).locator("text").boundingBox();
    if (box === null) throw new Error(`command ${label} is not on the timeline`);
    await this.#page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  }

  /** Presses at a share of the shown time, from 0 to 1, draws along to another and lets go. */
  async drag(from: number, to: number): Promise<void> {
    const { x, y } = await this.placeAt(from);
    await this.#page.mouse.move(x, y);
    await this.#page.mouse.down();
    for (const share of [0.25, 0.5, 0.75, 1]) {
      const at = await this.placeAt(from + (to - from) * share);
      await this.#page.mouse.move(at.x, at.y);
    }
    await this.#page.mouse.up();
  }

  /** A place on the ribbon, on the screen. */
  async placeAt(share: number): Promise<{ x: number; y: number }> {
    const box = await this.slider.boundingBox();
    if (box === null) throw new Error("the timeline is not on the screen");
    return { x: box.x + 10 + (box.width - 20) * share, y: box.y + box.height * 0.6 };
  }

  /** Expects what a screen reader says of the shown moment. */
  async expectMoment(words: RegExp): Promise<void> {
    await expect(this.slider).toHaveAttribute("aria-valuetext", words);
  }
}
