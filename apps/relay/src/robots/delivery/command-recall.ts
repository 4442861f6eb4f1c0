/**
 * Recalls commands for their senders or the owner. A waiting command ends at the relay. For a
 * delivered command the relay asks the robot. The store retains the request, so that a disconnected
 * page is asked when it reconnects.
 */
import type { CommandRecord, RecallCause } from "@corridor/protocol";
import { changeBlockedStep, changeKeysStep, permitResetStep } from "../../commands/permissions.ts";
import { cancelStep, pauseStep, recalledStep } from "../../commands/state-machine.ts";
import type {
  BlockResult,
  KeyChange,
  KeysResult,
  ScriptChange,
  StoredKey,
} from "../../commands/robot-step.ts";
import type { RobotStore } from "../../store/robot-store.ts";
import type { TermedRecord } from "../../commands/robot-commands.ts";
import { Refusal } from "../../platform/errors/problems.ts";
import { noCommand } from "./command-log.ts";
import type { SerialQueue } from "../../platform/serial-queue.ts";

export interface CommandRecallParts {
  robot: string;
  store: RobotStore;
  work: SerialQueue;
  /** called with commands that have ended at the relay */
  ended(commands: readonly TermedRecord[]): void;
  /** asks the page, here or at another relay, to end a command */
  ask(seq: number, cause: RecallCause): void;
}

export class CommandRecall {
  readonly #parts: CommandRecallParts;

  constructor(parts: CommandRecallParts) {
    this.#parts = parts;
  }

  /**
   * Recalls one command for the key that sent it.
   * @returns the record; it has not ended yet if the robot is asked to end it
   * @throws Refusal no-command, or forbidden if another key sent it
   */
  async one({ hash }: StoredKey, seq: number): Promise<CommandRecord> {
    const { robot, store, work } = this.#parts;
    return work.run(async () => {
      const result = await store.commit(robot, cancelStep(seq, hash));
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

  /** Changes the robot's keys, and recalls the commands of removed keys. */
  async changeKeys(change: KeyChange): Promise<KeysResult> {
    const { robot, store, work } = this.#parts;
    return work.run(async () => {
      const result = await store.commit(robot, changeKeysStep(change));
      if (result.outcome === "changed") this.#parts.ended(result.ended);
      return result;
    });
  }

  /** Changes which scripts are blocked, and recalls the commands of a newly blocked script. */
  async changeBlocked(change: ScriptChange): Promise<BlockResult> {
    const { robot, store, work } = this.#parts;
    return work.run(async () => {
      const result = await store.commit(robot, changeBlockedStep(change));
      if (result.outcome === "changed") this.#parts.ended(result.ended);
      return result;
    });
  }

  /**
   * Pauses remote driving and recalls the commands of scripts, or resumes it.
   * @returns false if there is no such robot
   */
  async pause(isPaused: boolean): Promise<boolean> {
    const { robot, store, work } = this.#parts;
    return work.run(async () => {
      const ended = await store.commit(robot, pauseStep(isPaused));
      if (ended !== null) this.#parts.ended(ended);
      return ended !== null;
    });
  }

  /** Permits or forbids resets by scripts. @returns false if there is no such robot */
  async permitReset(mayReset: boolean): Promise<boolean> {
    const { robot, store, work } = this.#parts;
    return work.run(async () => store.commit(robot, permitResetStep(mayReset)));
  }

  /** Asks the page to end all recalled commands, because earlier requests may have been lost. */
  async askAgain(): Promise<void> {
    await this.#parts.work.run(async () => this.repeatRequests());
  }

  /** Same as `askAgain`, for callers that already run in the serial queue. */
  async repeatRequests(): Promise<void> {
    const { robot, store } = this.#parts;
    for (const { seq, cause } of await store.commit(robot, recalledStep()))
      this.#parts.ask(seq, cause);
  }
}

function notYourCommand(): Refusal {
  return new Refusal(
    "forbidden",
    "Another key sent this command, and only that key can cancel it. To end all commands, send stop.",
  );
}
