/**
 * Taking commands back: what waits ends at the relay; for what the robot has, the robot is asked. The
 * store keeps the wish, so that a page that was away is asked when it is back.
 */
import type { CommandRecord } from "@corridor/protocol";
import type { SessionStore, StoredKey, TermedRecord } from "../store/session-store.ts";
import { noCommand, notYourCommand } from "./command-refusals.ts";
import type { OrderedWork } from "./ordered-work.ts";

export interface CommandRecallParts {
  robot: string;
  store: SessionStore;
  work: OrderedWork;
  /** a command has ended at the relay */
  ended(termed: TermedRecord): void;
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
          this.#parts.ended(result.termed);
          return result.termed.record;
        case "delivered":
          this.#parts.ask(seq);
          return result.record;
        case "over":
          return result.record;
      }
    });
  }

  /** Asks the page for all that was taken back while it may not have heard. To be called in turn. */
  async askAgain(): Promise<void> {
    const { robot, store } = this.#parts;
    for (const seq of await store.recalled(robot)) this.#parts.ask(seq);
  }

  /** Takes back all that a driver has sent and that has not ended. */
  async allOf(driver: string, reason: string): Promise<void> {
    const { robot, store, work } = this.#parts;
    await work.run(async () => {
      for (const { seq } of await store.openCommands(robot)) {
        const result = await store.cancel(robot, seq, { driver, reason });
        if (result.outcome === "cancelled") this.#parts.ended(result.termed);
        if (result.outcome === "delivered") this.#parts.ask(seq);
      }
    });
  }
}
