/** Finds a program line on the page and focuses it. */

/** @param id of the line, from the workspace's `lineIds` */
export function lineElementId(id: number): string {
  return `program-line-${id}`;
}

/** Scrolls a line into view and focuses it. Does nothing while the program is not on the screen. */
export function focusLine(id: number): void {
  const line = document.getElementById(lineElementId(id));
  line?.focus();
  line?.scrollIntoView({ block: "nearest" });
}
