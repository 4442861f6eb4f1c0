/** The phone's sheet: how far it is open, and how a drag or a press changes that. */

const positions = ["closed", "half", "open"] as const;
export type SheetPosition = (typeof positions)[number];

/** A finger that moves less than this, in px, has pressed and not dragged. */
const DRAG_PX = 24;

/** After a press: closed, half, open, and closed again. */
export function pressed(position: SheetPosition): SheetPosition {
  return positions[(positions.indexOf(position) + 1) % positions.length] ?? "half";
}

/** After a drag by so many px (downward is positive): one step that way, or none. */
export function dragged(position: SheetPosition, by: number): SheetPosition {
  if (Math.abs(by) < DRAG_PX) return position;
  const next = positions.indexOf(position) + (by < 0 ? 1 : -1);
  return positions[next] ?? position;
}
