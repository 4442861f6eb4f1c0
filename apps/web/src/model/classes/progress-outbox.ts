/**
 * Progress of the student that the relay has not stored yet, in order. The tab stores it, so that it
 * survives a reload and a lost connection. One record at a time is on its way: a rejected one must
 * not be overtaken by the next.
 */
import { progressSchema, type Progress } from "@corridor/protocol";
import type { ClassReport, ClassSession } from "../../simulator/protocol/class-messages.ts";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";
import { PROGRESS_KEY } from "./stored-keys.ts";
import { ReportPace } from "./report-pace.ts";

/** Records that wait at most: hours without a connection. Later ones are lost. */
const MAX_RECORDS = 1_000;
/** Time after which an unconfirmed record is sent again, in ms. */
const REPEAT_MS = 6_000;

export interface OutboxPorts {
  /** sessionStorage */
  tab: KeyValueStorage;
  send: (report: ClassReport) => void;
  /** monotonic milliseconds */
  now: () => number;
  /** @returns a function that cancels the call */
  later: (call: () => void, ms: number) => () => void;
}

interface Stored {
  /** number of the first record */
  first: number;
  /** whether the first record was sent, so that the relay may have stored it */
  isSent: boolean;
  records: Progress[];
}

export class ProgressOutbox {
  readonly #ports: OutboxPorts;
  readonly #pace: ReportPace;
  #stored: Stored;
  #isConnected = false;
  /** whether an answer to the first record is due on this connection */
  #isWaiting = false;
  #cancel: () => void = () => undefined;

  constructor(ports: OutboxPorts) {
    this.#ports = ports;
    this.#pace = new ReportPace(ports.now());
    this.#stored = read(ports.tab.getItem(PROGRESS_KEY));
  }

  add(event: Progress): void {
    const { records } = this.#stored;
    // A record that the relay rejects would hold up all others.
    if (records.length >= MAX_RECORDS || !progressSchema.safeParse(event).success) return;
    records.push(event);
    this.#write();
    this.#sendNext();
  }

  /** The worker has reported the connection, or what the relay has stored. */
  follow({ status, student }: ClassSession): void {
    if (status.kind !== "connected" || student === null) {
      this.#isConnected = false;
      this.#isWaiting = false;
      return this.#cancel();
    }
    const { progress } = student.stored;
    const isNew = !this.#isConnected;
    this.#isConnected = true;
    if (isNew) this.#welcome(progress);
    else this.#confirm(progress);
    this.#sendNext();
  }

  /** The student has left the class. */
  close(): void {
    this.#isConnected = false;
    this.#cancel();
    this.#stored = { first: 1, isSent: false, records: [] };
  }

  /** Numbers the records by what the relay has: another device may have sent some meanwhile. */
  #welcome(progress: number): void {
    this.#confirm(progress);
    const { first } = this.#stored;
    if (first === progress + 1) return;
    Object.assign(this.#stored, { first: progress + 1, isSent: false });
    this.#write();
  }

  /** Only a record that was sent can be the stored one. */
  #confirm(progress: number): void {
    const { first, isSent, records } = this.#stored;
    if (!isSent || progress < first) return;
    this.#cancel();
    this.#isWaiting = false;
    this.#stored = { first: first + 1, isSent: false, records: records.slice(1) };
    this.#write();
  }

  #sendNext(): void {
    const { first, records } = this.#stored;
    const [event] = records;
    if (!this.#isConnected || this.#isWaiting || event === undefined) return;
    this.#cancel();
    const wait = this.#pace.take(this.#ports.now());
    if (wait > 0) {
      this.#cancel = this.#ports.later(() => this.#sendNext(), wait);
      return;
    }
    this.#isWaiting = true;
    this.#stored.isSent = true;
    // Before it is sent: after a reload, the relay may have it.
    this.#write();
    this.#ports.send({ type: "progress", seq: first, event });
    this.#cancel = this.#ports.later(() => {
      this.#isWaiting = false;
      this.#sendNext();
    }, REPEAT_MS);
  }

  #write(): void {
    try {
      this.#ports.tab.setItem(PROGRESS_KEY, JSON.stringify(this.#stored));
    } catch {
      // Without storage, a reload loses what is not confirmed yet.
    }
  }
}

function read(text: string | null): Stored {
  const none: Stored = { first: 1, isSent: false, records: [] };
  let input: unknown;
  try {
    input = JSON.parse(text ?? "null");
  } catch {
    return none;
  }
  if (typeof input !== "object" || input === null) return none;
  const { first, isSent, records } = input as Record<string, unknown>;
  if (typeof first !== "number" || typeof isSent !== "boolean" || !Array.isArray(records)) {
    return none;
  }
  const parsed = records.map((each) => progressSchema.safeParse(each));
  if (parsed.some(({ success }) => !success)) return none;
  return { first, isSent, records: parsed.flatMap(({ data }) => data ?? []) };
}
