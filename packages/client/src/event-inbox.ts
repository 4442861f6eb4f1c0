import { MAX_STORED_EVENTS, type CommandRecord, type Snapshot } from "@corridor/protocol";

/** An event; `kind` names its type. */
export type RobotEvent =
  /** a newer snapshot */
  | { kind: "snapshot"; snapshot: Snapshot }
  /** the state of a command of any script changed */
  | { kind: "command"; command: CommandRecord }
  /** states of commands were missed, for example by a slow reader */
  | { kind: "gap" };

/** Buffers the events of a robot for one reader. */
export class EventInbox {
  #waiting: RobotEvent[] = [];
  #isClosed = false;
  #wake: () => void = () => undefined;

  put(event: RobotEvent): void {
    // Holds only the newest snapshot.
    if (event.kind === "snapshot") {
      this.#waiting = this.#waiting.filter(({ kind }) => kind !== "snapshot");
    }
    // Replaces events by a gap if the reader is too slow, as the relay does.
    if (this.#waiting.length >= MAX_STORED_EVENTS) this.#waiting = [{ kind: "gap" }];
    this.#waiting.push(event);
    this.#wake();
  }

  close(): void {
    this.#isClosed = true;
    this.#wake();
  }

  /** Resolves with the next event; with null after `close`. */
  async next(): Promise<RobotEvent | null> {
    for (;;) {
      const event = this.#waiting.shift();
      if (event !== undefined) return event;
      if (this.#isClosed) return null;
      await new Promise<void>((resolve) => (this.#wake = resolve));
    }
  }
}
