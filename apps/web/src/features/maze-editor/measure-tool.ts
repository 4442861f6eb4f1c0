/**
 * The Measure tool: the user drags a tape from point to point, or places its points by keyboard.
 */
import type { Cell } from "@corridor/maze";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import { middleOf, type TapePoint } from "../../stage/page/tape.ts";

export class MeasureTool {
  readonly #view: StageViewStore;
  /** the pointer that draws the tape */
  #pointerId: number | null = null;

  constructor(view: StageViewStore) {
    this.#view = view;
  }

  /** The pointer is down: a new tape starts here. */
  begin(pointerId: number, point: TapePoint): void {
    this.#pointerId = pointerId;
    this.#view.setState({ tape: { from: point, to: point, isOpen: true } });
  }

  /** The pointer that draws the tape has moved. */
  drag(pointerId: number, point: TapePoint): void {
    const { tape } = this.#view.getState();
    if (pointerId !== this.#pointerId || tape === null) return;
    this.#view.setState({ tape: { ...tape, to: point } });
  }

  /**
   * The pointer that draws the tape is up: the tape stays. A press without a drag leaves no tape.
   */
  end(pointerId: number): void {
    const { tape } = this.#view.getState();
    if (pointerId !== this.#pointerId || tape === null) return;
    this.#pointerId = null;
    const hasLength = tape.from.x !== tape.to.x || tape.from.y !== tape.to.y;
    this.#view.setState({ tape: hasLength ? { ...tape, isOpen: false } : null });
  }

  /** Space or Enter on a square: its middle becomes the first or the second point. */
  press(cell: Cell): void {
    const { tape } = this.#view.getState();
    const point = middleOf(cell);
    this.#view.setState({
      tape:
        tape?.isOpen === true
          ? { ...tape, to: point, isOpen: false }
          : { from: point, to: point, isOpen: true },
    });
  }

  /** The keyboard's cursor has moved to a square: the second point of an open tape follows. */
  aim(cell: Cell): void {
    const { tape } = this.#view.getState();
    if (tape?.isOpen === true) this.#view.setState({ tape: { ...tape, to: middleOf(cell) } });
  }

  /** Removes the tape. @returns whether there was one */
  clear(): boolean {
    const hadTape = this.#view.getState().tape !== null;
    this.#pointerId = null;
    if (hadTape) this.#view.setState({ tape: null });
    return hadTape;
  }
}
