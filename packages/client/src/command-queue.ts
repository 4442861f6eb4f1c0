/**
 * The commands of one script that have not ended. They are sent one at a time, in order: the next
 * one follows after the relay has acknowledged the previous one.
 *
 * After a reconnect a command is sent again with its idempotency key and its age, so that the robot
 * never executes it twice or late.
 */
import {
  encodeFrame,
  hasEnded,
  isVelocity,
  TTL_MS,
  type CommandRecord,
  type Order,
  type ProblemDocument,
  isTemporary,
} from "@corridor/protocol";
import { ClientError } from "./client-error.ts";
import { CommandTimes } from "./command-times.ts";
import type { OutgoingMessage } from "./long-poll-connection.ts";
import type { Platform } from "./platform.ts";

/** Delay before a command is sent again after the relay was busy. */
const BUSY_DELAY_MS = 500;

/** The state that resolves the promise of a command. */
export type Until = "accepted" | "started" | "ended";

export interface CommandQueueOptions {
  platform: Pick<Platform, "clock" | "uniqueText">;
  /** timeout for responses of the relay in ms, including reconnects */
  responseMs: number;
  /** timeout for the robot to finish a command in ms */
  finishMs: number;
  connection: {
    readonly isConnected: boolean;
    send(message: OutgoingMessage): void;
    open(): void;
    close(): void;
  };
  /** called when the first command is added, and after the last one has ended */
  waits: (isWaiting: boolean) => void;
}

interface Pending {
  key: string;
  order: Order;
  /** time of the first attempt */
  firstSentAt: number | null;
  /** how often it may still be sent again if the relay counts it as too late although it is not */
  retriesIfEarly: number;
  until: Until;
  resolve: (record: CommandRecord) => void;
  reject: (error: ClientError) => void;
  cancelTimer(): void;
}

export class CommandQueue {
  readonly #options: CommandQueueOptions;
  readonly #times: CommandTimes;
  /** not yet acknowledged on this connection, in order; only the first was sent */
  #queue: Pending[] = [];
  /** acknowledged and not yet ended, by seq */
  readonly #running = new Map<number, Pending>();
  #cancelRetry: () => void = () => undefined;

  constructor(options: CommandQueueOptions) {
    this.#options = options;
    this.#times = new CommandTimes(options.platform.clock);
  }

  /**
   * Adds a command.
   * @param order a valid one
   * @param key idempotency key
   * @returns the record, once the command has the state `until`; for `accepted` in any state
   * @throws ClientError refused, cancelled, superseded, expired, timeout, or that of `close`
   */
  add(
    order: Order,
    until: Until,
    key: string = this.#options.platform.uniqueText(),
  ): Promise<CommandRecord> {
    return new Promise((resolve, reject) => {
      const pending: Pending = {
        key,
        order,
        firstSentAt: null,
        retriesIfEarly: 2,
        until,
        resolve,
        reject,
        cancelTimer: () => undefined,
      };
      this.#limit(pending, this.#options.responseMs, "The robot's host does not respond");
      this.#queue.push(pending);
      this.#options.waits(true);
      if (this.#queue.length === 1) this.#sendFirst();
    });
  }

  /** To be called when a new connection sends `hello`. @returns its `sentAt` */
  start(): number {
    return this.#times.start();
  }

  /** @param isSameStream whether the relay will send the states that were missed */
  welcomed(isSameStream: boolean): void {
    this.#times.answered();
    if (!isSameStream) this.#repeatRunning();
  }

  /** The response to the first command may be lost; states of acknowledged ones follow. */
  connected(): void {
    this.#sendFirst();
  }

  /** States were missed. */
  missed(): void {
    this.#repeatRunning();
    this.#sendFirst();
  }

  acknowledged(record: CommandRecord): void {
    const [first] = this.#queue;
    if (first === undefined || first.key !== record.key) return;
    this.#times.answered();
    if (first.until === "accepted") {
      first.resolve(record);
      return this.#remove(first);
    }
    this.#queue.shift();
    this.#limit(first, this.#options.finishMs, "The robot did not finish");
    this.#running.set(record.seq, first);
    this.progressed(record);
    this.#sendFirst();
  }

  progressed(record: CommandRecord): void {
    const pending = this.#running.get(record.seq);
    if (pending === undefined) return;
    const { state } = record;
    // Less early, it expired by its round trip, and its reason helps.
    if (state === "expired" && this.#isOnly() && this.#isEarly(pending, 0.5)) {
      return this.#sendAgain(record.seq, pending);
    }
    const isFailed = state === "cancelled" || state === "expired";
    if (isFailed || (state === "superseded" && pending.until === "ended")) {
      this.#remove(pending);
      const ended = state === "expired" ? state : `was ${state}`;
      const what = `Command ${record.seq} (${record.action}) ${ended}`;
      const hint = record.reason ?? "Another script drives this robot as well.";
      return pending.reject(new ClientError(state, what, hint));
    }
    if (hasEnded(state) || (state === "started" && pending.until === "started")) {
      this.#remove(pending);
      pending.resolve(record);
    }
  }

  /** @param key of the refused command; null if the relay does not know it */
  refused(problem: ProblemDocument, key: string | null): void {
    const [first] = this.#queue;
    if (first === undefined || (key !== null && key !== first.key)) return;
    if (key !== null) this.#times.answered();
    if (isTemporary(problem)) {
      this.#cancelRetry();
      const { clock } = this.#options.platform;
      this.#cancelRetry = clock.after(BUSY_DELAY_MS, () => this.#sendFirst());
      return;
    }
    const isLate = problem.type === "/problems/too-late";
    if (isLate && this.#isEarly(first)) return this.#retryRejected(first);
    this.#remove(first);
    const code = isLate ? "expired" : "refused";
    first.reject(new ClientError(code, problem.title, problem.detail, { cause: problem }));
  }

  /** Rejects all commands. None may be added later. */
  close(error: ClientError): void {
    this.#cancelRetry();
    this.#options.waits(false);
    for (const pending of [...this.#running.values(), ...this.#queue]) {
      pending.cancelTimer();
      pending.reject(error);
    }
    this.#running.clear();
    this.#queue = [];
  }

  #sendFirst(): void {
    const { platform, connection } = this.#options;
    if (!connection.isConnected) return;
    this.#dropOldVelocities();
    const [first] = this.#queue;
    if (first === undefined) return;
    const firstSentAt = (first.firstSentAt ??= platform.clock.now());
    const { key, order } = first;
    connection.send(() => {
      const { sentAt, age } = this.#times.next(firstSentAt);
      const command = age === 0 ? order : { ...order, age };
      return encodeFrame({ type: "command", key, sentAt, command });
    });
  }

  /** After a reconnect, the robot must not execute outdated velocities one by one. */
  #dropOldVelocities(): void {
    for (;;) {
      const [older, newer] = this.#queue;
      if (newer === undefined || older === undefined) return;
      if (!isVelocity(older.order) || !isVelocity(newer.order) || older.order.replace === true)
        return;
      this.#queue.shift();
      older.cancelTimer();
      const { resolve, reject } = newer;
      newer.resolve = (record) => {
        older.resolve(record);
        resolve(record);
      };
      newer.reject = (error) => {
        older.reject(error);
        reject(error);
      };
    }
  }

  #limit(pending: Pending, ms: number, what: string): void {
    pending.cancelTimer();
    pending.cancelTimer = this.#options.platform.clock.after(ms, () => {
      this.#remove(pending);
      const hint = "Check that the robot's page is open, connected and not paused.";
      pending.reject(new ClientError("timeout", what, hint));
    });
  }

  #remove(pending: Pending): void {
    pending.cancelTimer();
    const wasFirst = this.#queue[0] === pending;
    this.#queue = this.#queue.filter((other) => other !== pending);
    for (const [seq, other] of this.#running) if (other === pending) this.#running.delete(seq);
    if (this.#queue.length + this.#running.size === 0) this.#options.waits(false);
    if (wasFirst) this.#sendFirst();
  }

  /** Sending a command again with the same key returns its current record. */
  #repeatRunning(): void {
    this.#queue = [...this.#running.values(), ...this.#queue];
    this.#running.clear();
  }

  /**
   * Whether a command may be sent again, because it is young by this computer's clock.
   * @param part of its time to live
   */
  #isEarly({ firstSentAt, order, retriesIfEarly }: Pending, part = 1): boolean {
    const age = this.#options.platform.clock.now() - (firstSentAt ?? 0);
    return retriesIfEarly > 0 && age < part * (order.ttl ?? TTL_MS.default);
  }

  /** Whether no other command is under way, which one that is sent again could overtake or follow. */
  #isOnly(): boolean {
    return this.#queue.length === 0 && this.#running.size === 1;
  }

  /**
   * The relay rejected a command that has not expired. Either the response has shown a shorter
   * round trip, or the clock stopped while this computer slept; then a new connection measures
   * anew.
   */
  #retryRejected(first: Pending): void {
    first.retriesIfEarly -= 1;
    if (first.retriesIfEarly > 0) return this.#sendFirst();
    this.#options.connection.close();
    this.#options.connection.open();
  }

  /**
   * The relay accepted a command that has not expired, and it expired at the relay: the round trips
   * before it were longer. The old key belongs to the expired command.
   */
  #sendAgain(seq: number, pending: Pending): void {
    this.#running.delete(seq);
    pending.key = this.#options.platform.uniqueText();
    pending.retriesIfEarly = 0;
    this.#limit(pending, this.#options.responseMs, "The robot's host does not respond");
    this.#queue.push(pending);
    this.#sendFirst();
  }
}
