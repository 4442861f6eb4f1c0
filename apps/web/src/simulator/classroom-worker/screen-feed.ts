/** Sends the content of the big screens when it has changed, at most once in a second. */
import type { ScreenContent, ScreenNumbers, Tile } from "@corridor/protocol";
import type { ScreenUpdate } from "../protocol/classroom-messages.ts";

/** The relay accepts two a second. */
const INTERVAL_MS = 1_000;

export interface ScreenFeedPorts {
  tileOf(student: number): Tile | null;
  isSolved(student: number, task: number): boolean;
  /** @param priority see `ScreenPriority` */
  send(content: ScreenContent, priority: number): void;
  /** Calls once after `ms`. */
  after(ms: number, call: () => void): void;
}

export class ScreenFeed {
  readonly #ports: ScreenFeedPorts;
  #numbers: ScreenNumbers | null = null;
  #student: number | null = null;
  #program: string | null = null;
  #priority = 0;
  #sent = "";
  #isWaiting = false;

  constructor(ports: ScreenFeedPorts) {
    this.#ports = ports;
  }

  /**
   * @param student whose run is on the big screens; null: none
   * @param program of the student, as a link text; null: not known
   */
  show({ numbers, student, program, priority }: ScreenUpdate): void {
    this.#numbers = numbers;
    this.#student = student;
    this.#program = program;
    this.#priority = priority;
    this.#send();
  }

  /** These students have new tiles. */
  changed(students: readonly number[]): void {
    if (this.#student !== null && students.includes(this.#student)) this.#send();
  }

  /** A new connection, or the dashboard in control has closed: the relay may not have the content. */
  repeat(): void {
    this.#sent = "";
    this.#send();
  }

  #send(): void {
    if (this.#isWaiting || this.#numbers === null) return;
    const content = { ...this.#numbers, run: this.#run() };
    // A choice makes this device control the screens, also if they show the same as before.
    const text = JSON.stringify([content, this.#priority]);
    if (text === this.#sent) return;
    this.#sent = text;
    this.#ports.send(content, this.#priority);
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
