/**
 * What of a layer has been drawn on, as a few rectangles. Before the next picture only these are wiped:
 * a robot with its beams covers a hundredth of a stage, and a screen's pixels are many.
 *
 * Numbers live in one array that is used again and again, so that a frame leaves no garbage behind.
 */
import type { Brush } from "./brush.ts";

/** More rectangles than a picture with every beam, tag and arrow has; beyond it everything is dirty. */
const MAX_BOXES = 64;
/** Pixels around a box for the soft edge of what was drawn. */
const EDGE = 2;

export class Dirt {
  readonly #boxes = new Float64Array(MAX_BOXES * 4);
  #count = 0;
  #isEverywhere = false;

  /** Notes a rectangle in CSS pixels of the view. */
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

  /** Notes a line from point to point with so many pixels on either side. */
  addLine(fromX: number, fromY: number, toX: number, toY: number, half: number): void {
    const left = Math.min(fromX, toX) - half;
    const top = Math.min(fromY, toY) - half;
    this.add(left, top, Math.abs(toX - fromX) + 2 * half, Math.abs(toY - fromY) + 2 * half);
  }

  /**
   * Wipes all that was noted, and forgets it.
   * @param pixelRatio device pixels per CSS pixel: whole device pixels are wiped, half ones would leave a shadow
   */
  wipe(brush: Brush, pixelRatio: number, view: { width: number; height: number }): void {
    brush.setTransform(1, 0, 0, 1, 0, 0);
    if (this.#isEverywhere) {
      brush.clearRect(0, 0, view.width * pixelRatio, view.height * pixelRatio);
    } else {
      for (let at = 0; at < 4 * this.#count; at += 4) {
        const left = Math.floor((this.#boxes[at] ?? 0) * pixelRatio);
        const top = Math.floor((this.#boxes[at + 1] ?? 0) * pixelRatio);
        const right = Math.ceil((this.#boxes[at + 2] ?? 0) * pixelRatio);
        const bottom = Math.ceil((this.#boxes[at + 3] ?? 0) * pixelRatio);
        brush.clearRect(left, top, right - left, bottom - top);
      }
    }
    brush.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    this.forget();
  }

  /** The layer is empty. */
  forget(): void {
    this.#count = 0;
    this.#isEverywhere = false;
  }
}
