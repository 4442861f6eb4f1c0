/**
 * Taking commands back: what waits ends at the relay; for what the robot has, the robot is asked. The
 * store keeps the wish, so that a page that was away is asked when it is back.
 */
import type { CommandRecord } from "@corridor/protocol";
import type {
  KeyChange,
  KeysResult,
  SessionStore,
  StoredKey,
  TermedRecord,
} from "../store/session-store.ts";
import { noCommand, notYourCommand } from "./command-refusals.ts";
import type { OrderedWork } from "./ordered-work.ts";

export interface CommandRecallParts {
  robot: string;
  store: SessionStore;
  work: OrderedWork;
  /** commands have ended at the relay */
  ended(commands: readonly TermedRecord[]): void;
  /** asks the page, wherever it is, to end a command */
  ask(seq: number): void;
}

export class CommandRecall {
  readonly #parts: CommandRecallParts;

  constructor(parts: CommandRecallParts) {
    this.#parts = parts;
  }

  /**
   * Takes one command back for the key that sent it.
   * @returns the record, which has not ended yet where the robot was asked
   * @throws Refusal when there is no such command, or another key sent it
   */
  async one({ hash }: StoredKey, seq: number): Promise<CommandRecord> {
    const { robot, store, work } = this.#parts;
    return work.run(async () => {
      const by = { driver: hash, reason: "cancelled by its sender" };
      const result = await store.cancel(robot, seq, by);
      switch (result.outcome) {
        case "no-command":
          throw noCommand(seq);
        case "not-yours":
          throw notYourCommand();
        case "cancelled":
          this.#parts.ended([result.termed]);
          return result.termed.record;
        case "delivered":
          this.#parts.ask(seq);
          return result.record;
        case "over":
          return result.record;
      }
    });
  }

  /** Changes the robot's keys, and takes back what those that go have sent. */
  async changeKeys(change: KeyChange): Promise<KeysResult> {
    const { robot, store, work } = this.#parts;
    return work.run(async () => {
      const result = await store.changeKeys(robot, change);
      if (result.outcome === "changed") this.#parts.ended(result.ended);
      return result;
    });
  }

  /** Asks the page for all that was taken back and may not have been heard. */
  async askAgain(): Promise<void> {
    await this.#parts.work.run(async () => this.askAgainInTurn());
  }

  /** The same, for whoever has the turn. */
  async askAgainInTurn(): Promise<void> {
    const { robot, store } = this.#parts;
    for (const seq of await store.recalled(robot)) this.#parts.ask(seq);
  }
}
