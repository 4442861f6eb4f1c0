/**
 * Taking commands back: what waits ends at the relay; for what the robot has, the robot is asked. The
 * store keeps the wish, so that a page that was away is asked when it is back.
 */
import {
  BLOCKED_REASON,
  PAUSED_REASON,
  recallCauses,
  REVOKED_REASON,
  type CommandRecord,
  type RecallCause,
} from "@corridor/protocol";
import type {
  AwayResult,
  KeyChange,
  KeysResult,
  ScriptChange,
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
  ask(seq: number, cause: RecallCause): void;
}

/** As the record of a command says it. */
const reasons = {
  sender: "The script cancelled this command before it started. To run it, send a new command.",
  revoked: REVOKED_REASON,
  blocked: BLOCKED_REASON,
  paused: PAUSED_REASON,
} as const satisfies Record<RecallCause, string>;

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
      const by = { driver: hash, reason: reasons.sender };
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
          this.#parts.ask(seq, "sender");
          return result.record;
        case "over":
          return result.record;
      }
    });
  }

  /** Changes the robot's keys, and takes back what those that go have sent. */
  async changeKeys(change: Omit<KeyChange, "reason">): Promise<KeysResult> {
    const { robot, store, work } = this.#parts;
    return work.run(async () => {
      const result = await store.changeKeys(robot, { ...change, reason: reasons.revoked });
      if (result.outcome === "changed") this.#parts.ended(result.ended);
      return result;
    });
  }

  /** Changes which scripts are away, and takes back what one that goes has sent. */
  async changeAway(change: Omit<ScriptChange, "reason">): Promise<AwayResult> {
    const { robot, store, work } = this.#parts;
    return work.run(async () => {
      const result = await store.changeAway(robot, { ...change, reason: reasons["blocked"] });
      if (result.outcome === "changed") this.#parts.ended(result.ended);
      return result;
    });
  }

  /** Pauses remote driving and takes back what scripts have sent, or lets them drive again. */
  async pause(isPaused: boolean): Promise<boolean> {
    const { robot, store, work } = this.#parts;
    return work.run(async () => {
      const ended = await store.pause(robot, isPaused, reasons.paused);
      if (ended !== null) this.#parts.ended(ended);
      return ended !== null;
    });
  }

  /** Asks the page for all that was taken back and may not have been heard. */
  async askAgain(): Promise<void> {
    await this.#parts.work.run(async () => this.askAgainInTurn());
  }

  /** The same, for whoever has the turn. */
  async askAgainInTurn(): Promise<void> {
    const { robot, store } = this.#parts;
    for (const { seq, reason } of await store.recalled(robot)) {
      this.#parts.ask(seq, causeOf(reason));
    }
  }
}

function causeOf(reason: string): RecallCause {
  return recallCauses.find((cause) => reasons[cause] === reason) ?? "sender";
}
