/** The newest marks of scripts, by cell. They are not stored. */
import type { CellMark, Marks } from "@corridor/protocol";
import { lateMarks } from "../../stage/layers/late-marks.ts";
import { drawMarks } from "../../stage/layers/marks.ts";

export class MarkedCells {
  readonly #cells = new Map<string, CellMark>();
  #shown: readonly CellMark[] = [];
  #isHidden = false;

  constructor() {
    lateMarks.draw = drawMarks;
  }

  add({ fresh, cells }: Marks): void {
    if (fresh) this.#cells.clear();
    for (const mark of cells) {
      const key = `${mark.column} ${mark.row}`;
      const isEmpty = mark.text === "" && mark.color === null && mark.walls === "";
      if (isEmpty) this.#cells.delete(key);
      else this.#cells.set(key, mark);
    }
    this.#update();
  }

  hide(isHidden: boolean): void {
    this.#isHidden = isHidden;
    this.#update();
  }

  /** The marks to draw; another list after each change. */
  get shown(): readonly CellMark[] {
    return this.#shown;
  }

  #update(): void {
    this.#shown = this.#isHidden ? [] : [...this.#cells.values()];
  }
}
