/**
 * The dirty rectangles of a layer. Before the next frame only these are erased: a robot with its
 * beams covers a hundredth of the stage.
 *
 * The numbers live in one array that is reused, so that a frame allocates nothing.
 */
import type { DrawingContext } from "./drawing-context.ts";

/**
 * More rectangles than a frame with every beam, label and arrow has. Beyond it the whole layer is
 * dirty.
 */
const MAX_BOXES = 64;
/** Pixels around a box for the anti-aliased edge of a drawing. */
const EDGE = 2;

export class DirtyRects {
  readonly #boxes = new Float64Array(MAX_BOXES * 4);
  #count = 0;
  #isEverywhere = false;

  /** Adds a rectangle, in CSS pixels of the view. */
  add(x: number, y: number, width: number, height: number): void {
    if (this.#count === MAX_BOXES) {
      this.#isEverywhere = true;
      return;
    }
    const at = 4 * this.#count++;
    this.#boxes[at] = x - EDGE;
    this.#boxes[at + 1] = y - EDGE;
    this.#boxes[at + 2] = x + width + EDGE;
    this.#boxes[at + 3] = y + height + EDGE;
  }

  /**
   * Adds the bounding box of a line.
   * @param half half the width of the line, in CSS pixels
   */
  addLine(fromX: number, fromY: number, toX: number, toY: number, half: number): void {
    const left = Math.min(fromX, toX) - half;
    const top = Math.min(fromY, toY) - half;
    this.add(left, top, Math.abs(toX - fromX) + 2 * half, Math.abs(toY - fromY) + 2 * half);
  }

  /**
   * Erases the dirty rectangles and empties the list.
   * @param pixelRatio device pixels per CSS pixel; only whole device pixels are erased, because
   *   half ones would leave a shadow
   */
  erase(
    context: DrawingContext,
    pixelRatio: number,
    view: { width: number; height: number },
  ): void {
    context.setTransform(1, 0, 0, 1, 0, 0);
    if (this.#isEverywhere) {
      context.clearRect(0, 0, view.width * pixelRatio, view.height * pixelRatio);
    } else {
      for (let at = 0; at < 4 * this.#count; at += 4) {
        const left = Math.floor((this.#boxes[at] ?? 0) * pixelRatio);
        const top = Math.floor((this.#boxes[at + 1] ?? 0) * pixelRatio);
        const right = Math.ceil((this.#boxes[at + 2] ?? 0) * pixelRatio);
        const bottom = Math.ceil((this.#boxes[at + 3] ?? 0) * pixelRatio);
        context.clearRect(left, top, right - left, bottom - top);
      }
    }
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    this.reset();
  }

  /** Empties the list without erasing. */
  reset(): void {
    this.#count = 0;
    this.#isEverywhere = false;
  }
}
