/**
 * The newest marks of scripts, by cell. They are not stored. Scripts repeat them every second, so
 * marks of a script whose end was missed are removed.
 */
import type { CellMark, Marks } from "@corridor/protocol";
import { lateMarks } from "../../stage/layers/late-marks.ts";
import { drawMarks } from "../../stage/layers/marks.ts";

/** Time without a message after which marks are removed. */
const LEASE_MS = 5_000;

export class MarkedCells {
  readonly #onChange: () => void;
  readonly #cells = new Map<string, CellMark>();
  #shown: readonly CellMark[] = [];
  #isHidden = false;
  #lease: ReturnType<typeof setTimeout> | undefined;

  /** @param onChange called after each change of `shown` */
  constructor(onChange: () => void) {
    this.#onChange = onChange;
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
    clearTimeout(this.#lease);
    if (this.#cells.size > 0) this.#lease = setTimeout(() => this.clear(), LEASE_MS);
    this.#update();
  }

  clear(): void {
    this.#cells.clear();
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
    this.#onChange();
  }
}
