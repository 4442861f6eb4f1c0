/**
 * A user without a mouse: moves to controls with Tab and presses keys. Each step fails when the
 * focus is lost or cannot be seen.
 */
import { expect, type Locator, type Page } from "playwright/test";

export class KeyboardUser {
  readonly #page: Page;

  constructor(page: Page) {
    this.#page = page;
  }

  /** Moves the focus to a control with Tab. From the end of the page, Tab continues at its top. */
  async tabTo(target: Locator, maxPresses = 120): Promise<void> {
    await expect(target).toBeVisible();
    const isFocused = () => target.evaluate((element) => element === document.activeElement);
    for (let stop = 0; stop < maxPresses; stop++) {
      if (await isFocused()) return this.expectFocusVisible();
      await this.#page.keyboard.press("Tab");
    }
    expect(
      await isFocused(),
      `reached with ${maxPresses} presses of Tab: ${target.toString()}`,
    ).toBe(true);
  }

  /** Moves the focus to a control and presses a key. */
  async press(target: Locator, key = "Enter"): Promise<void> {
    await this.tabTo(target);
    await this.key(key);
  }

  /** Presses keys at the current focus, and expects that the focus is not lost. */
  async key(...keys: string[]): Promise<void> {
    for (const key of keys) await this.#page.keyboard.press(key);
    await this.expectFocus();
  }

  /** Selects an option of a menu by typing the start of its label. */
  async choose(menu: Locator, label: string): Promise<void> {
    await this.tabTo(menu);
    // Stop before the first character that no key types: the letters before it are enough.
    await this.#page.keyboard.type(/^[\x20-\x7e]*/.exec(label)?.[0] ?? "");
    await expect(menu.locator("option:checked")).toHaveText(label);
    await this.expectFocus();
  }

  /** Replaces the text of a field. */
  async type(field: Locator, text: string): Promise<void> {
    await this.tabTo(field);
    await this.#page.keyboard.press("Control+a");
    await this.#page.keyboard.type(text);
  }

  /** Expects that an element has the focus: a page that loses it sends the user back to its top. */
  async expectFocus(): Promise<void> {
    await expect
      .poll(() => this.#page.evaluate(() => document.activeElement?.tagName), {
        message: "something has the focus",
      })
      .not.toBe("BODY");
  }

  /** Expects a focus ring that is visible, not clipped or covered. */
  async expectFocusVisible(): Promise<void> {
    await expect.poll(() => this.#page.evaluate(focusDefect)).toBeNull();
  }
}

/** Why the focus is not visible, or null when it is. Runs in the page. */
function focusDefect(): string | null {
  const focused = document.activeElement;
  if (!(focused instanceof HTMLElement)) return "nothing has the focus";
  const name = `${focused.tagName} ${focused.getAttribute("aria-label") ?? focused.textContent}`;
  const { width, height, left, top, right, bottom } = focused.getBoundingClientRect();
  if (width < 2 || height < 2) return `${name} has no size`;
  const isOnScreen = right > 0 && bottom > 0 && left < innerWidth && top < innerHeight;
  if (!isOnScreen) return `${name} is off the screen`;
  // Some controls have their ring on an element around them.
  for (let at: Element | null = focused; at !== null; at = at.parentElement) {
    const { outlineStyle, outlineWidth } = getComputedStyle(at);
    if (outlineStyle !== "none" && Number.parseFloat(outlineWidth) >= 2) return null;
    if (at.matches("section, dialog, li")) break;
  }
  return `${name} has no ring`;
}
