/** Positions of the phone's sheet, and how a drag or a press changes them. */

const positions = ["closed", "half", "open"] as const;
export type SheetPosition = (typeof positions)[number];

/** Movement below this, in px, is a press instead of a drag. */
const DRAG_PX = 24;

/** After a press: closed, half, open, and closed again. */
export function afterPress(position: SheetPosition): SheetPosition {
  return positions[(positions.indexOf(position) + 1) % positions.length] ?? "half";
}

/** After a drag by this many px (positive is downward): one step in its direction, or none. */
export function afterDrag(position: SheetPosition, by: number): SheetPosition {
  if (Math.abs(by) < DRAG_PX) return position;
  const next = positions.indexOf(position) + (by < 0 ? 1 : -1);
  return positions[next] ?? position;
}
