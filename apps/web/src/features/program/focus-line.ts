/** Where a program line is on the page, for whoever leads the reader to it. */

/** @param id of the line, from the workspace's `lineIds` */
export function lineElementId(id: number): string {
  return `program-line-${id}`;
}

/** Brings a line into view and gives it the focus; does nothing while the program is not on the screen. */
export function focusLine(id: number): void {
  const line = document.getElementById(lineElementId(id));
  line?.focus();
  line?.scrollIntoView({ block: "nearest" });
}
