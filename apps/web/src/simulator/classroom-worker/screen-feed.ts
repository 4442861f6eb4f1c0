/** Sends the content of the big screens when it has changed, at most once in a second. */
import type { ScreenContent, ScreenNumbers, Tile } from "@corridor/protocol";

/** The relay accepts two a second. */
const INTERVAL_MS = 1_000;

export interface ScreenFeedPorts {
  tileOf(student: number): Tile | null;
  isSolved(student: number, task: number): boolean;
  send(content: ScreenContent): void;
  /** Calls once after `ms`. */
  after(ms: number, call: () => void): void;
}

export class ScreenFeed {
  readonly #ports: ScreenFeedPorts;
  #numbers: ScreenNumbers | null = null;
  #student: number | null = null;
  #program: string | null = null;
  #sent = "";
  #isWaiting = false;

  constructor(ports: ScreenFeedPorts) {
    this.#ports = ports;
  }

  /**
   * @param student whose run is on the big screens; null: none
   * @param program of the student, as a link text; null: not known
   */
  show(numbers: ScreenNumbers, student: number | null, program: string | null): void {
    this.#numbers = numbers;
    this.#student = student;
    this.#program = program;
    this.#send();
  }

  /** These students have new tiles. */
  changed(students: readonly number[]): void {
    if (this.#student !== null && students.includes(this.#student)) this.#send();
  }

  /** A new connection: the relay may not have the content. */
  repeat(): void {
    this.#sent = "";
    this.#send();
  }

  #send(): void {
    if (this.#isWaiting || this.#numbers === null) return;
    const content = { ...this.#numbers, run: this.#run() };
    const text = JSON.stringify(content);
    if (text === this.#sent) return;
    this.#sent = text;
    this.#ports.send(content);
    this.#isWaiting = true;
    this.#ports.after(INTERVAL_MS, () => {
      this.#isWaiting = false;
      this.#send();
    });
  }

  #run(): ScreenContent["run"] {
    const student = this.#student;
    const tile = student === null ? null : this.#ports.tileOf(student);
    if (student === null || tile === null) return null;
    const { task, maze, pose, path, state } = tile;
    const line = state === "driving" ? tile.line : null;
    const isSolved = this.#ports.isSolved(student, task);
    return { task, maze, pose, path, line, program: this.#program, isSolved };
  }
}
