/** Events of a robot for one reader that takes them at its own pace. */
import { MAX_STORED_EVENTS, type CommandRecord, type Snapshot } from "@corridor/protocol";

/** One thing that happened; `kind` says what. */
export type RobotEvent =
  /** a newer snapshot */
  | { kind: "snapshot"; snapshot: Snapshot }
  /** the state of a command of any script changed */
  | { kind: "command"; command: CommandRecord }
  /** states of commands were missed, as after a long pause in reading */
  | { kind: "gap" };

export class EventInbox {
  #waiting: RobotEvent[] = [];
  #isOver = false;
  #wake: () => void = () => undefined;

  put(event: RobotEvent): void {
    // Of reports only the newest counts.
    if (event.kind === "snapshot") {
      this.#waiting = this.#waiting.filter(({ kind }) => kind !== "snapshot");
    }
    // A reader that is this late starts over, as one that the relay has no earlier events for.
    if (this.#waiting.length >= MAX_STORED_EVENTS) this.#waiting = [{ kind: "gap" }];
    this.#waiting.push(event);
    this.#wake();
  }

  close(): void {
    this.#isOver = true;
    this.#wake();
  }

  /** The next event, once there is one; null when there is none any more. */
  async next(): Promise<RobotEvent | null> {
    for (;;) {
      const event = this.#waiting.shift();
      if (event !== undefined) return event;
      if (this.#isOver) return null;
      await new Promise<void>((resolve) => (this.#wake = resolve));
    }
  }
}
