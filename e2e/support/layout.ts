/** Layout checks of the page: horizontal overflow, touch target sizes and readable texts. */
import type { Page } from "playwright/test";

/** Controls beyond the left or right edge, and the page itself if it scrolls horizontally. */
export async function horizontalOverflow(page: Page): Promise<string[]> {
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

/** Controls smaller than a touch target of 44 px, with their sizes. */
export async function smallTouchTargets(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const minimum = 44 - 0.5;
    const controls = [...document.querySelectorAll("button, select, input, textarea, a[href]")];
    return controls.flatMap((control) => {
      // A radio is pressed through its label, a checkbox through its whole row.
      const target = control.matches("[type=radio]")
        ? (control.closest("label") ?? control)
        : control.matches("[type=checkbox]")
          ? (control.parentElement ?? control)
          : control;
      if (!target.checkVisibility()) return [];
      // A skip link is clipped until it has the focus.
      if (getComputedStyle(target).clipPath === "inset(50%)") return [];
      const { width, height } = target.getBoundingClientRect();
      if (width >= minimum && height >= minimum) return [];
      const name = control.getAttribute("aria-label") ?? target.textContent;
      return [`${name}: ${width.toFixed(0)} x ${height.toFixed(0)}`];
    });
  });
}

/**
 * Fields with a font below 16 px, with their sizes: an iPhone zooms into the page when one is
 * focused.
 */
export async function fieldsThatZoom(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const fields = [...document.querySelectorAll("input, select, textarea")].filter(
      (field) =>
        field.checkVisibility() && !field.matches("[type=radio], [type=checkbox], [type=range]"),
    );
    return fields.flatMap((field) => {
      const size = Number.parseFloat(getComputedStyle(field).fontSize);
      const name = field.getAttribute("aria-label") ?? field.outerHTML.slice(0, 80);
      return size < 16 ? [`${name}: ${size}`] : [];
    });
  });
}

/**
 * Texts that cannot be read: clipped by a container, wider than their control, off the screen, or
 * overlapping. Checks the topmost dialog or menu, or else the whole page.
 * @param within selector of a part that covers the page, to check it alone
 */
export async function unreadableTexts(page: Page, within = "body"): Promise<string[]> {
  return page.evaluate((selector) => {
    interface Box {
      left: number;
      right: number;
      top: number;
      bottom: number;
    }
    const slack = 1.5;
    const open = [...document.querySelectorAll("dialog[open], :popover-open")];
    const root = open.at(-1) ?? document.querySelector(selector) ?? document.body;
    const faults = new Set<string>();
    const seen: { box: Box; text: string; control: Element | null }[] = [];
    const { clientWidth, scrollWidth } = document.documentElement;
    if (scrollWidth > clientWidth) faults.add(`the page is ${scrollWidth} px wide`);

    const isHidden = (element: Element): boolean => {
      for (let at: Element | null = element; at !== null; at = at.parentElement) {
        if (getComputedStyle(at).clipPath === "inset(50%)") return true;
      }
      return !element.checkVisibility({ visibilityProperty: true, opacityProperty: true });
    };

    const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
      const text = node.textContent?.trim() ?? "";
      const holder = node.parentElement;
      if (text === "" || holder === null || isHidden(holder)) continue;
      if (holder.closest("svg, option, script, style, pre, code") !== null) continue;
      const range = document.createRange();
      range.selectNodeContents(node);
      const control = holder.closest("button, label, [role=tab], [role=menuitemradio], kbd");
      for (const rect of range.getClientRects()) {
        let visible: Box = {
          left: rect.left,
          right: rect.right,
          top: rect.top,
          bottom: rect.bottom,
        };
        let isScrolledOut = false;
        for (let at: Element | null = holder; at !== null && at !== root; at = at.parentElement) {
          const style = getComputedStyle(at);
          if (style.overflowX === "visible") continue;
          const edge = at.getBoundingClientRect();
          // Names get an ellipsis; the full name is visible where it is edited.
          if (style.textOverflow === "ellipsis") continue;
          const isCut = visible.left < edge.left - slack || visible.right > edge.right + slack;
          if (isCut && !isScrolledOut) faults.add(`cut off: ${text}`);
          const isScroller = style.overflowY === "auto" || style.overflowY === "scroll";
          if (isScroller) {
            visible = {
              ...visible,
              top: Math.max(visible.top, edge.top),
              bottom: Math.min(visible.bottom, edge.bottom),
            };
            if (visible.bottom - visible.top < 2) isScrolledOut = true;
          } else if (style.overflowY !== "visible") {
            // A font reserves more height than its letters use.
            const tolerance = Math.max(4, rect.height / 5);
            const isLow =
              visible.bottom > edge.bottom + tolerance || visible.top < edge.top - tolerance;
            if (isLow && !isScrolledOut) faults.add(`cut off below: ${text}`);
          }
        }
        if (isScrolledOut) continue;
        if (visible.left < -slack || visible.right > clientWidth + slack) {
          faults.add(`off the screen: ${text}`);
        }
        if (control !== null) {
          const edge = control.getBoundingClientRect();
          if (visible.left < edge.left - slack || visible.right > edge.right + slack) {
            faults.add(`wider than its control: ${text}`);
          }
          if (visible.top < edge.top - 4 || visible.bottom > edge.bottom + 4) {
            faults.add(`taller than its control: ${text}`);
          }
        }
        seen.push({ box: visible, text, control });
      }
    }

    // The text of a select is no text node, so measure it with the same font.
    const pen = document.createElement("canvas").getContext("2d");
    for (const select of root.querySelectorAll("select")) {
      if (pen === null || isHidden(select)) continue;
      const style = getComputedStyle(select);
      pen.font = style.font;
      const text = select.selectedOptions[0]?.textContent ?? "";
      const available =
        select.clientWidth -
        Number.parseFloat(style.paddingInlineStart) -
        Number.parseFloat(style.paddingInlineEnd);
      const width = pen.measureText(text).width;
      if (width > available + 2)
        faults.add(`cut off in a menu, ${(width - available).toFixed(0)} px: ${text}`);
    }

    const overlaps = (one: Box, other: Box): boolean =>
      Math.min(one.right, other.right) - Math.max(one.left, other.left) > 3 &&
      Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top) > 5;
    for (const [at, one] of seen.entries()) {
      for (const other of seen.slice(at + 1)) {
        if (one.text !== other.text && overlaps(one.box, other.box)) {
          faults.add(`overlapping: ${one.text} | ${other.text}`);
        }
      }
    }
    return [...faults];
  }, within);
}
