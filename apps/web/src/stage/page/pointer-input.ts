/**
 * Turns pointer events over the maze into intents: hover over a cell, paint cells, end, cancel.
 *
 * A press paints immediately, and a drag paints every cell on its path. Where the maze is larger
 * than the stage, a finger scrolls it and paints only by a tap. A second finger is a pinch, which
 * cancels the stroke of the first.
 */
import type { Cell } from "@corridor/maze";

export type Intent =
  /** the pointer rests over a cell, or outside of the maze */
  | { type: "hover"; cell: Cell | null }
  /** a stroke starts with this cell */
  | { type: "begin"; cell: Cell }
  /** the stroke continues over these cells */
  | { type: "paint"; cells: readonly Cell[] }
  | { type: "end" }
  /** the stroke was a gesture: undo its edits */
  | { type: "cancel" };

/** The part of a PointerEvent that PointerInput needs. */
export interface PointerDetails {
  pointerId: number;
  pointerType: string;
  button: number;
  isPrimary: boolean;
  /** the cell under the pointer; null outside of the maze or on a ruler */
  cell: Cell | null;
}

type Stroke =
  | { kind: "painting"; pointerId: number; last: Cell }
  /** a finger that may turn out to scroll */
  | { kind: "tapping"; pointerId: number; cell: Cell };

export class PointerInput {
  readonly #emit: (intent: Intent) => void;
  /** whether touch scrolls the stage */
  #doesTouchScroll = false;
  #stroke: Stroke | null = null;

  constructor(emit: (intent: Intent) => void) {
    this.#emit = emit;
  }

  setTouchScroll(doesTouchScroll: boolean): void {
    this.#doesTouchScroll = doesTouchScroll;
  }

  down(event: PointerDetails): void {
    if (!event.isPrimary) return this.cancel();
    if (event.button !== 0 || event.cell === null || this.#stroke !== null) return;
    const { cell, pointerId } = event;
    if (event.pointerType === "touch" && this.#doesTouchScroll) {
      this.#stroke = { kind: "tapping", pointerId, cell };
      return;
    }
    this.#stroke = { kind: "painting", pointerId, last: cell };
    this.#emit({ type: "hover", cell: null });
    this.#emit({ type: "begin", cell });
  }

  move(event: PointerDetails): void {
    const stroke = this.#stroke;
    if (stroke === null) {
      if (event.pointerType !== "touch") this.#emit({ type: "hover", cell: event.cell });
      return;
    }
    if (stroke.pointerId !== event.pointerId || event.cell === null) return;
    if (stroke.kind === "tapping") {
      if (!isSame(stroke.cell, event.cell)) this.#stroke = null;
      return;
    }
    if (isSame(stroke.last, event.cell)) return;
    const cells = cellsBetween(stroke.last, event.cell);
    this.#stroke = { ...stroke, last: event.cell };
    this.#emit({ type: "paint", cells });
  }

  up(event: PointerDetails): void {
    const stroke = this.#stroke;
    if (stroke === null || stroke.pointerId !== event.pointerId) return;
    this.#stroke = null;
    if (stroke.kind === "tapping") this.#emit({ type: "begin", cell: stroke.cell });
    this.#emit({ type: "end" });
    if (event.pointerType !== "touch") this.#emit({ type: "hover", cell: event.cell });
  }

  /** The browser cancelled the pointer, Escape was pressed, or a second finger came down. */
  cancel(): void {
    const stroke = this.#stroke;
    this.#stroke = null;
    if (stroke?.kind === "painting") this.#emit({ type: "cancel" });
  }

  leave(): void {
    if (this.#stroke === null) this.#emit({ type: "hover", cell: null });
  }
}

function isSame(a: Cell, b: Cell): boolean {
  return a.column === b.column && a.row === b.row;
}

/**
 * The cells from one cell to another, without the first: a fast pointer skips cells between two
 * events. Neighbours in the result share a side or a corner.
 */
export function cellsBetween(from: Cell, to: Cell): Cell[] {
  const columns = to.column - from.column;
  const rows = to.row - from.row;
  const count = Math.max(Math.abs(columns), Math.abs(rows));
  return Array.from({ length: count }, (_, at) => ({
    column: from.column + Math.round((columns * (at + 1)) / count),
    row: from.row + Math.round((rows * (at + 1)) / count),
  }));
}
