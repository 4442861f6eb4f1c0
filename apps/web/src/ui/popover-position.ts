/**
 * Position of a popover: below its button, aligned with one of its edges, and inside the window.
 */

interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** Distance to the button and to the edges of the window, in px. */
const GAP = 6;
const MARGIN = 8;

/**
 * @param button the button's box in the window, in px
 * @param size   the popover's own size, in px
 * @param view   the window's size, in px
 * @param align  which edge of the button the popover shares
 * @returns the popover's left and top in the window, in px
 */
export function placePopover(
  button: Box,
  size: { width: number; height: number },
  view: { width: number; height: number },
  align: "left" | "right",
): { left: number; top: number } {
  const wanted = align === "left" ? button.left : button.right - size.width;
  const below = button.bottom + GAP;
  const above = button.top - GAP - size.height;
  const fitsBelow = below + size.height + MARGIN <= view.height;
  return {
    left: Math.max(MARGIN, Math.min(wanted, view.width - size.width - MARGIN)),
    top: fitsBelow
      ? below
      : above >= MARGIN
        ? above
        : Math.max(MARGIN, view.height - size.height - MARGIN),
  };
}
