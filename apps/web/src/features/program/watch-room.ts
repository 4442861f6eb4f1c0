/**
 * How much room the lines of a program have: where it is small their fields stand closer, and then below
 * each other. A container query would say the same, but has all lines laid out once more at every turn.
 */

/** Up to how many letters' heights (em) wide the lines are, for each word that they are given. */
const ROOMS = [
  ["tight", 24.66],
  ["narrow", 22.39],
  ["slim", 17],
] as const;

/**
 * Keeps `data-room` true: the words of all rooms that the lines fit in, for stylesheets.
 * @param lines get the attribute
 * @param rod as wide as the lines and one em high, so that it tells of other letters too
 * @returns a function that ends it
 */
export function watchRoom(lines: HTMLElement, rod: HTMLElement): () => void {
  const look = (): void => {
    const { width, height } = rod.getBoundingClientRect();
    const rooms = ROOMS.filter(([, most]) => width <= most * height);
    lines.dataset["room"] = rooms.map(([name]) => name).join(" ");
  };
  // Once before the first paint: otherwise rows that do not fit yet move what is below them.
  look();
  const observer = new ResizeObserver(look);
  observer.observe(rod);
  return () => observer.disconnect();
}
