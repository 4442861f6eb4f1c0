/** Page object of the timeline of a run, for pointer and keyboard. */
import { expect, type Locator, type Page } from "playwright/test";

export class TimelinePanel {
  readonly #page: Page;
  readonly #transport: Locator;
  readonly slider: Locator;

  constructor(page: Page, transport: Locator) {
    this.#page = page;
    this.#transport = transport;
    this.slider = transport.getByRole("slider", { name: "Timeline" });
  }

  /** The mark of the displayed tick. It has no role, since the slider's value reports the tick. */
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

  get previousDecision(): Locator {
    return this.#transport.getByRole("button", { name: "One decision back" });
  }

  /** The clock's label while an earlier tick is displayed. */
  get pastLabel(): Locator {
    return this.#transport.getByText("in the past", { exact: true });
  }

  /**
   * Event icons above the ribbon. They have no role, since the slider's value reports the events.
   */
  mark(kind: "bump" | "goal" | "turn" | "edit"): Locator {
    return this.#transport.locator(`[data-kind=${kind}]`);
  }

  /** The times below the ribbon. */
  get axis(): Locator {
    return this.#transport.locator("svg g > g > text");
  }

  /** Attached also where they are hidden. */
  get zoomButtons(): Locator {
    return this.#transport.getByRole("group", { name: "Timeline zoom", includeHidden: true });
  }

  get zoomIn(): Locator {
    return this.#transport.getByRole("button", { name: "Zoom in on the timeline" });
  }

  get wholeRun(): Locator {
    return this.#transport.getByRole("button", { name: "Whole run" });
  }

  /** The scroll bar of a zoomed timeline. */
  get visiblePart(): Locator {
    return this.#transport.getByRole("region", { name: "Visible part of the run" });
  }

  /** The numbered mark of a script's command, or of a range of commands: "3", "3–7". */
  command(label: string): Locator {
    return this.#transport.locator(`[data-command="${label}"]`);
  }

  /** Clicks the number of a command. */
  async pressCommand(label: string): Promise<void> {
    const box = await this.command(label).locator("text").boundingBox();
    if (box === null) throw new Error(`command ${label} is not on the timeline`);
    await this.#page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  }

  /** Drags from one fraction of the displayed time range to another. Fractions are from 0 to 1. */
  async drag(from: number, to: number): Promise<void> {
    const { x, y } = await this.pointAt(from);
    await this.#page.mouse.move(x, y);
    await this.#page.mouse.down();
    for (const share of [0.25, 0.5, 0.75, 1]) {
      const at = await this.pointAt(from + (to - from) * share);
      await this.#page.mouse.move(at.x, at.y);
    }
    await this.#page.mouse.up();
  }

  /** The screen coordinates of a fraction of the ribbon. */
  async pointAt(share: number): Promise<{ x: number; y: number }> {
    const box = await this.slider.boundingBox();
    if (box === null) throw new Error("the timeline is not on the screen");
    return { x: box.x + 10 + (box.width - 20) * share, y: box.y + box.height * 0.6 };
  }

  /** Expects the slider's value text, which describes the displayed tick. */
  async expectValueText(text: RegExp): Promise<void> {
    await expect(this.slider).toHaveAttribute("aria-valuetext", text);
  }
}
