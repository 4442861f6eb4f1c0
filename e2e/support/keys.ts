/**
 * A reader who has no mouse: goes to controls with Tab as often as it takes, presses keys, and notices at
 * once when the focus is nowhere or cannot be seen.
 */
import { expect, type Locator, type Page } from "playwright/test";

export class Keys {
  readonly #page: Page;

  constructor(page: Page) {
    this.#page = page;
  }

  /** Goes to a control with Tab; from the end of the page Tab begins at its top again. */
  async goTo(target: Locator, most = 120): Promise<void> {
    await expect(target).toBeVisible();
    const isThere = () => target.evaluate((element) => element === document.activeElement);
    for (let stop = 0; stop < most; stop++) {
      if (await isThere()) return this.expectFocusSeen();
      await this.#page.keyboard.press("Tab");
    }
    expect(await isThere(), `reached with ${most} presses of Tab: ${target.toString()}`).toBe(true);
  }

  /** Goes to a control and presses a key on it. */
  async press(target: Locator, key = "Enter"): Promise<void> {
    await this.goTo(target);
    await this.key(key);
  }

  /** Presses a key wherever the focus is; afterwards it is still somewhere. */
  async key(...keys: string[]): Promise<void> {
    for (const key of keys) await this.#page.keyboard.press(key);
    await this.expectFocus();
  }

  /** Chooses an option of a menu by the letters that it begins with. */
  async choose(menu: Locator, label: string): Promise<void> {
    await this.goTo(menu);
    // What no key types is left out: the letters before it are enough.
    await this.#page.keyboard.type(/^[\x20-\x7e]*/.exec(label)?.[0] ?? "");
    await expect(menu.locator("option:checked")).toHaveText(label);
    await this.expectFocus();
  }

  /** Types into a field, in place of what stands there. */
  async type(field: Locator, text: string): Promise<void> {
    await this.goTo(field);
    await this.#page.keyboard.press("Control+a");
    await this.#page.keyboard.type(text);
  }

  /** Expects that something has the focus: a page that lost it sends its reader back to its top. */
  async expectFocus(): Promise<void> {
    await expect
      .poll(() => this.#page.evaluate(() => document.activeElement?.tagName), {
        message: "something has the focus",
      })
      .not.toBe("BODY");
  }

  /** Expects that the focus can be seen: a ring that nothing cuts off or hides. */
  async expectFocusSeen(): Promise<void> {
    await expect.poll(() => this.#page.evaluate(faultOfFocus)).toBeNull();
  }
}

/** Why the focus cannot be seen; null when it can. Runs in the page. */
function faultOfFocus(): string | null {
  const focused = document.activeElement;
  if (!(focused instanceof HTMLElement)) return "nothing has the focus";
  const name = `${focused.tagName} ${focused.getAttribute("aria-label") ?? focused.textContent}`;
  const { width, height, left, top, right, bottom } = focused.getBoundingClientRect();
  if (width < 2 || height < 2) return `${name} has no size`;
  const isOn = right > 0 && bottom > 0 && left < innerWidth && top < innerHeight;
  if (!isOn) return `${name} is off the screen`;
  // Some controls are drawn by what is around them.
  for (let at: Element | null = focused; at !== null; at = at.parentElement) {
    const { outlineStyle, outlineWidth } = getComputedStyle(at);
    if (outlineStyle !== "none" && Number.parseFloat(outlineWidth) >= 2) return null;
    if (at.matches("section, dialog, li")) break;
  }
  return `${name} has no ring`;
}
