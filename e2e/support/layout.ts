/** Measures the page as it lies on the screen: what sticks out sideways, what is too small for a finger. */
import type { Page } from "playwright/test";

/** Controls that reach over the left or right edge, and the page itself if it scrolls sideways. */
export async function stickingOut(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const { clientWidth, scrollWidth } = document.documentElement;
    const controls = [...document.querySelectorAll("button, select, input, textarea, label")];
    const out = controls.filter((control) => {
      if (!control.checkVisibility() || control.closest(".visually-hidden") !== null) return false;
      const { left, right } = control.getBoundingClientRect();
      return left < -0.5 || right > clientWidth + 0.5;
    });
    const names = out.map((control) => control.outerHTML.slice(0, 120));
    return scrollWidth > clientWidth ? [`the page is ${scrollWidth} px wide`, ...names] : names;
  });
}

/** Buttons, menus, fields and choices that are smaller than a finger needs, with their size. */
export async function tooSmallToTouch(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const least = 44 - 0.5;
    const controls = [...document.querySelectorAll("button, select, input, textarea, a[href]")];
    return controls.flatMap((control) => {
      // A radio is pressed by the label around it, a checkbox by the whole of its row.
      const target = control.matches("[type=radio]")
        ? (control.closest("label") ?? control)
        : control.matches("[type=checkbox]")
          ? (control.parentElement ?? control)
          : control;
      if (!target.checkVisibility()) return [];
      const { width, height } = target.getBoundingClientRect();
      if (width >= least && height >= least) return [];
      const name = control.getAttribute("aria-label") ?? target.textContent;
      return [`${name}: ${width.toFixed(0)} x ${height.toFixed(0)}`];
    });
  });
}
