/** Queries for the commands of one robot: one command, a list, the open ones, or the end of one. */
import { hasEnded, type CommandRecord, type EventGap } from "@corridor/protocol";
import type { RobotStore } from "../../store/robot-store.ts";
import type { Subscribers, CallerWait } from "../readers/subscribers.ts";
import { Refusal } from "../../platform/errors/problems.ts";
import { limits } from "../../platform/limits/limits.ts";
import type { SerialQueue } from "../../platform/serial-queue.ts";

export class CommandLog {
  readonly #robot: string;
  readonly #store: RobotStore;
  readonly #subscribers: Subscribers;
  readonly #work: SerialQueue;

  /** @param work queue of all changes to commands; some reads run between two changes */
  constructor(robot: string, store: RobotStore, subscribers: Subscribers, work: SerialQueue) {
    this.#robot = robot;
    this.#store = store;
    this.#subscribers = subscribers;
    this.#work = work;
  }

  /** @throws Refusal no-command */
  async command(seq: number): Promise<CommandRecord> {
    const record = await this.#store.command(this.#robot, seq);
    if (record === null) throw noCommand(seq);
    return record;
  }

  async after(seq: number): Promise<CommandRecord[]> {
    return this.#store.commandsAfter(this.#robot, seq, limits.logPage);
  }

  /** Reports the commands that have not ended, between two changes. */
  async readOpen(notify: (open: EventGap["open"]) => void): Promise<void> {
    await this.#work.run(async () => {
      const open = await this.#store.openCommands(this.#robot);
      notify(open.map(({ seq, state }) => ({ seq, state })));
    });
  }

  /** Waits for the command to end. @returns its record after the wait, ended or not */
  async endOf(seq: number, waitLimit: CallerWait): Promise<CommandRecord> {
    // Starts between two changes, so that no ending falls between the read and the subscription.
    const { record, end } = await this.#work.run(async () => {
      const now = await this.command(seq);
      return { record: now, end: hasEnded(now.state) ? null : this.#nextEnd(seq, waitLimit) };
    });
    if (end === null) return record;
    await end;
    return this.command(seq);
  }

  #nextEnd(seq: number, waitLimit: CallerWait): Promise<void> {
    return this.#subscribers.until(waitLimit, (done) => ({
      state: ({ record }) => {
        if (record.seq === seq && hasEnded(record.state)) done();
      },
    }));
  }
}

/** Error response if the robot has no such command. */
export function noCommand(seq: number): Refusal {
  return new Refusal(
    "no-command",
    `This robot has no command ${seq}. List its commands with GET .../commands.`,
  );
}
