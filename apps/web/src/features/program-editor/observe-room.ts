/**
 * Observes how much width the lines of a program have. On little width their fields move closer
 * together, and then below each other. A container query would lay out all lines once more on every
 * turn.
 */

/** Maximum width of the lines in em for each word of `data-room`. */
const ROOMS = [
  ["tight", 24.66],
  ["narrow", 22.39],
  ["slim", 17],
] as const;

/**
 * Updates `data-room` with the words of all rooms that apply, for stylesheets.
 * @param lines the element with the attribute
 * @param rod as wide as the lines and one em high, so that it reflects the font size
 * @returns a function that stops observing
 */
export function observeRoom(lines: HTMLElement, rod: HTMLElement): () => void {
  const look = (): void => {
    const { width, height } = rod.getBoundingClientRect();
    const rooms = ROOMS.filter(([, most]) => width <= most * height);
    lines.dataset["room"] = rooms.map(([name]) => name).join(" ");
  };
  // The call before the first paint avoids a layout shift below rows that do not fit.
  look();
  const observer = new ResizeObserver(look);
  observer.observe(rod);
  return () => observer.disconnect();
}
