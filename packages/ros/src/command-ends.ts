/**
 * Waits for the ends of commands by the states of a subscription. Each wait of the port counts as
 * one more reader of the robot, and readers are limited for all scripts. So there is one such wait at
 * a time: it is a request of the script, which motions without an end require to continue.
 */
import { hasEnded, type CommandRecord, type EventGap, type RobotPort } from "@corridor/protocol";

/** The longest wait of a port. */
const WAIT_MS = 25_000;

type Settle = (record: CommandRecord | Promise<CommandRecord>) => void;

export class CommandEnds {
  readonly #port: RobotPort;
  /** by the number of the command */
  readonly #waits = new Map<number, Settle>();
  /** commands that ended while one is being sent, whose number is not known yet */
  readonly #early = new Map<number, CommandRecord>();
  #sending = 0;
  #isWaiting = false;
  #isClosed = false;

  constructor(port: RobotPort) {
    this.#port = port;
  }

  /** A command of any script has changed. */
  state(record: CommandRecord): void {
    if (!hasEnded(record.state)) return;
    if (this.#sending > 0) this.#early.set(record.seq, record);
    this.#settle(record.seq, record);
  }

  /** States were missed: all commands have ended except these. */
  gap(open: EventGap["open"]): void {
    const seqs = new Set(open.map(({ seq }) => seq));
    for (const seq of this.#waits.keys()) {
      if (!seqs.has(seq)) this.#settle(seq, this.#port.endOf(seq, 0));
    }
  }

  close(): void {
    this.#isClosed = true;
  }

  /** Sends a command. @returns its record, and that of its end, which may never resolve */
  async send(
    request: () => Promise<CommandRecord>,
  ): Promise<{ record: CommandRecord; end: Promise<CommandRecord> }> {
    this.#sending += 1;
    try {
      const record = await request();
      return { record, end: this.#endOf(record) };
    } finally {
      this.#sending -= 1;
      if (this.#sending === 0) this.#early.clear();
    }
  }

  async #endOf(record: CommandRecord): Promise<CommandRecord> {
    const early = this.#early.get(record.seq);
    if (early !== undefined || hasEnded(record.state)) return early ?? record;
    return new Promise((resolve) => {
      this.#waits.set(record.seq, resolve);
      void this.#wait();
    });
  }

  /** Waits at the port while a command has not ended. */
  async #wait(): Promise<void> {
    if (this.#isWaiting) return;
    this.#isWaiting = true;
    try {
      for (let [seq] = this.#waits.keys(); seq !== undefined; [seq] = this.#waits.keys()) {
        const record = await this.#port.endOf(seq, WAIT_MS);
        if (this.#isClosed) return;
        this.state(record);
      }
    } catch {
      // The states follow all the same, or the subscription ends for the same reason.
    } finally {
      this.#isWaiting = false;
    }
  }

  #settle(seq: number, record: CommandRecord | Promise<CommandRecord>): void {
    this.#waits.get(seq)?.(record);
    this.#waits.delete(seq);
  }
}
