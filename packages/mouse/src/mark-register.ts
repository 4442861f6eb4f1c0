/**
 * What a micromouse program draws over the maze: a text, a colour and assumed walls of each cell.
 * Display commands only change this register. It is published as messages of changed cells, at most
 * ten a second, however many commands arrive.
 */
import {
  MAX_MARKED_CELLS,
  type CellMark,
  type MarkColor,
  type Marks,
  type Timers,
} from "@corridor/protocol";
import { colorOf } from "./mark-colors.ts";
import type { MazeFrame } from "./maze-frame.ts";
import { sideNames, type DisplayCommand, type SideName } from "./mouse-command.ts";

const INTERVAL_MS = 100;
/** Marks are repeated this often, also while others change: for new viewers, and after a reload. */
const REPEAT_MS = 1_000;
const MAX_TEXT = 10;

interface Cell {
  x: number;
  y: number;
  text: string;
  color: MarkColor | null;
  walls: Set<SideName>;
}

/** The neighbour at each side. */
const steps: Record<SideName, { x: number; y: number }> = {
  n: { x: 0, y: 1 },
  e: { x: 1, y: 0 },
  s: { x: 0, y: -1 },
  w: { x: -1, y: 0 },
};

export class MarkRegister {
  readonly #frame: MazeFrame;
  readonly #timers: Timers;
  readonly #publish: (message: Marks) => void;
  readonly #cells = new Map<number, Cell>();
  readonly #changed = new Set<Cell>();
  #lastMs = Number.NEGATIVE_INFINITY;
  #cancelSend: (() => void) | null = null;
  #cancelRepeat: (() => void) | null = null;
  /** the cells that are repeated next */
  #repeated = this.#cells.values();

  constructor(frame: MazeFrame, timers: Timers, publish: (message: Marks) => void) {
    this.#frame = frame;
    this.#timers = timers;
    this.#publish = publish;
  }

  /** Cells outside of the maze are ignored. */
  apply(command: DisplayCommand): void {
    if (!("x" in command)) {
      for (const cell of this.#cells.values()) {
        if (command.do === "clear-all-color") this.#setColor(cell, null);
        else this.#setText(cell, "");
      }
      return;
    }
    const cell = this.#cellAt(command);
    if (cell === null) return;
    switch (command.do) {
      case "set-color":
        return this.#setColor(cell, colorOf(command.color));
      case "clear-color":
        return this.#setColor(cell, null);
      case "set-text":
        return this.#setText(cell, command.text.replace(/[^ -~]/gu, "?").slice(0, MAX_TEXT));
      case "clear-text":
        return this.#setText(cell, "");
      case "set-wall":
      case "clear-wall":
        return this.#setWall(cell, command.side, command.do === "set-wall");
    }
  }

  close(): void {
    this.#cancelSend?.();
    this.#cancelRepeat?.();
  }

  #cellAt({ x, y }: { x: number; y: number }): Cell | null {
    if (!this.#frame.has({ x, y })) return null;
    const at = y * this.#frame.columns + x;
    const cell = this.#cells.get(at) ?? { x, y, text: "", color: null, walls: new Set() };
    this.#cells.set(at, cell);
    return cell;
  }

  #setColor(cell: Cell, color: MarkColor | null): void {
    if (cell.color === color) return;
    cell.color = color;
    this.#change(cell);
  }

  #setText(cell: Cell, text: string): void {
    if (cell.text === text) return;
    cell.text = text;
    this.#change(cell);
  }

  /** A wall belongs to the cells at both of its sides. */
  #setWall(cell: Cell, side: SideName, isSet: boolean): void {
    const { x, y } = steps[side];
    const neighbour = this.#cellAt({ x: cell.x + x, y: cell.y + y });
    const back = sideNames[(sideNames.indexOf(side) + 2) % 4] ?? side;
    this.#setSide(cell, side, isSet);
    if (neighbour !== null) this.#setSide(neighbour, back, isSet);
  }

  #setSide(cell: Cell, side: SideName, isSet: boolean): void {
    if (cell.walls.has(side) === isSet) return;
    if (isSet) cell.walls.add(side);
    else cell.walls.delete(side);
    this.#change(cell);
  }

  #change(cell: Cell): void {
    this.#changed.add(cell);
    const waitMs = Math.max(0, this.#lastMs + INTERVAL_MS - this.#timers.now());
    this.#cancelSend ??= this.#timers.after(waitMs, () => this.#send());
  }

  #send(): void {
    this.#cancelSend = null;
    this.#lastMs = this.#timers.now();
    const cells = [...this.#changed].slice(0, MAX_MARKED_CELLS);
    for (const cell of cells) this.#changed.delete(cell);
    const marks = cells.map((cell) => this.#markOf(cell));
    this.#publish({ fresh: false, pitch: this.#frame.pitch, cells: marks });
    const [next] = this.#changed;
    if (next !== undefined) this.#change(next);
    this.#cancelRepeat ??= this.#timers.after(REPEAT_MS, () => this.#repeat());
  }

  /** Sends the next cells again. Ends when no cell has marks. */
  #repeat(): void {
    this.#cancelRepeat = null;
    const isMarked = ({ text, color, walls }: Cell): boolean =>
      text !== "" || color !== null || walls.size > 0;
    for (let count = 0; count < this.#cells.size; count += 1) {
      let next = this.#repeated.next();
      if (next.done === true) {
        this.#repeated = this.#cells.values();
        next = this.#repeated.next();
      }
      if (next.done !== true && isMarked(next.value)) this.#change(next.value);
      if (this.#changed.size >= MAX_MARKED_CELLS) return;
    }
  }

  #markOf({ x, y, text, color, walls }: Cell): CellMark {
    const isWall = (side: number): boolean =>
      [...walls].some((each) => this.#frame.mapSideOf(sideNames.indexOf(each)) === side);
    const sides = sideNames.filter((_, side) => isWall(side)).join("");
    return { ...this.#frame.blockOf({ x, y }), text, color, walls: sides };
  }
}
