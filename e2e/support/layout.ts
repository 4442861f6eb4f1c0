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

/** Fields whose letters are so small that an iPhone zooms into the page when one is touched, in px. */
export async function zoomedInto(page: Page): Promise<string[]> {
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
 * Texts that cannot be read: cut off by what holds them, wider than their button or menu, off the
 * screen, or printed over one another. Asked of the topmost dialog or menu, else of the whole page.
 * @param within selector of a part that lies over the page, to ask of it alone
 */
export async function unreadable(page: Page, within = "body"): Promise<string[]> {
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
        let shown: Box = { left: rect.left, right: rect.right, top: rect.top, bottom: rect.bottom };
        let isScrolledAway = false;
        for (let at: Element | null = holder; at !== null && at !== root; at = at.parentElement) {
          const style = getComputedStyle(at);
          if (style.overflowX === "visible") continue;
          const edge = at.getBoundingClientRect();
          // An ellipsis stands where readers name things: the whole name is where it is edited.
          if (style.textOverflow === "ellipsis") continue;
          const isCut = shown.left < edge.left - slack || shown.right > edge.right + slack;
          if (isCut && !isScrolledAway) faults.add(`cut off: ${text}`);
          const isScroller = style.overflowY === "auto" || style.overflowY === "scroll";
          if (isScroller) {
            shown = {
              ...shown,
              top: Math.max(shown.top, edge.top),
              bottom: Math.min(shown.bottom, edge.bottom),
            };
            if (shown.bottom - shown.top < 2) isScrolledAway = true;
          } else if (style.overflowY !== "visible") {
            // A font reserves more height than its letters take.
            const air = Math.max(4, rect.height / 5);
            const isLow = shown.bottom > edge.bottom + air || shown.top < edge.top - air;
            if (isLow && !isScrolledAway) faults.add(`cut off below: ${text}`);
          }
        }
        if (isScrolledAway) continue;
        if (shown.left < -slack || shown.right > clientWidth + slack) {
          faults.add(`off the screen: ${text}`);
        }
        if (control !== null) {
          const edge = control.getBoundingClientRect();
          if (shown.left < edge.left - slack || shown.right > edge.right + slack) {
            faults.add(`wider than its control: ${text}`);
          }
          if (shown.top < edge.top - 4 || shown.bottom > edge.bottom + 4) {
            faults.add(`higher than its control: ${text}`);
          }
        }
        seen.push({ box: shown, text, control });
      }
    }

    // What a select shows is no text of the page: it is measured with the same letters.
    const pen = document.createElement("canvas").getContext("2d");
    for (const select of root.querySelectorAll("select")) {
      if (pen === null || isHidden(select)) continue;
      const style = getComputedStyle(select);
      pen.font = style.font;
      const text = select.selectedOptions[0]?.textContent ?? "";
      const room =
        select.clientWidth -
        Number.parseFloat(style.paddingInlineStart) -
        Number.parseFloat(style.paddingInlineEnd);
      const width = pen.measureText(text).width;
      if (width > room + 2)
        faults.add(`cut off in a menu, ${(width - room).toFixed(0)} px: ${text}`);
    }

    const isOver = (one: Box, other: Box): boolean =>
      Math.min(one.right, other.right) - Math.max(one.left, other.left) > 3 &&
      Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top) > 5;
    for (const [at, one] of seen.entries()) {
      for (const other of seen.slice(at + 1)) {
        if (one.text !== other.text && isOver(one.box, other.box)) {
          faults.add(`printed over one another: ${one.text} | ${other.text}`);
        }
      }
    }
    return [...faults];
  }, within);
}
