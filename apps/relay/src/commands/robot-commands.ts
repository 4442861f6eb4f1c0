/**
 * A robot's commands in memory, which the state machine changes: all open commands, and those ended
 * ones that a store has not released. A store is notified of each change, and stores it.
 *
 * A command is a row here, a record for readers, and a record with its terms for the robot. Rows are
 * validated before they are written. Validating them again in each step took a third of the cost of
 * a command.
 */
import {
  hasEnded,
  type CommandRecord,
  type CommandState,
  type RecallCause,
  type RemoteCommand,
} from "@corridor/protocol";
import { reasonText, type Reason } from "./reasons.ts";
import { KeyIndex } from "./key-index.ts";

/**
 * Commands that overtake end the accepted commands before them, and are delivered regardless of the
 * window. A stop cancels the commands before it, a replacement supersedes them. In order of precedence: a
 * stop also cancels what a replacement has overtaken.
 */
export const overtakingKinds = ["stop", "replace"] as const;
export type Overtaking = (typeof overtakingKinds)[number];

/**
 * How a command overtakes; null: it waits. This is the only place that decides it. Rows hold the
 * result, and queries of a store use the stored result.
 */
export function overtakingOf(command: RemoteCommand, replace: boolean): Overtaking | null {
  if (command.action === "stop") return "stop";
  return replace || command.action === "reset" ? "replace" : null;
}

export interface CommandRow {
  readonly seq: number;
  readonly driver: string;
  readonly script: string | null;
  readonly key: string | null;
  readonly command: RemoteCommand;
  /** the command as JSON, for comparison */
  readonly text: string;
  readonly acceptedAt: number;
  readonly ttl: number;
  readonly deadline: number;
  readonly replace: boolean;
  readonly lease: number | null;
  /** null: it waits for earlier commands */
  readonly overtakes: Overtaking | null;
  state: CommandState;
  reason: Reason | null;
  /** why it was cancelled although the robot already has it */
  recalled: RecallCause | null;
  pose: CommandRecord["pose"];
  distance: number | null;
  /** of the page to which it was delivered */
  epoch: number | null;
}

/** A command and its text. */
export interface InternedCommand {
  readonly command: RemoteCommand;
  /** the command as JSON */
  readonly text: string;
}

const MAX_KNOWN = 512;
/** Longer commands, with many conditions, are seldom sent twice. */
const MAX_KNOWN_LENGTH = 1_024;
const known = new Map<string, InternedCommand>();

/**
 * Interns commands, because robots receive the same few commands repeatedly. Equal commands share
 * one immutable object.
 * @param text a command as JSON
 * @throws SyntaxError if it is not JSON
 */
export function commandIn(text: string): InternedCommand {
  const before = known.get(text);
  if (before !== undefined) return before;
  // A shortened command has a digest in place of its conditions.
  const { digest: _digest, ...command } = JSON.parse(text) as RemoteCommand & { digest?: string };
  const made = { command: Object.freeze(command), text };
  if (text.length > MAX_KNOWN_LENGTH) return made;
  if (known.size >= MAX_KNOWN) known.clear();
  known.set(text, made);
  return made;
}

/** A record with the command details that only the relay and the robot need. */
export interface TermedRecord {
  record: CommandRecord;
  /** hash of the key that sent it */
  driver: string;
  /** id of the script that sent it; null if an earlier version of Corridor stored it */
  script: string | null;
  ttl: number;
  deadline: number;
  replace: boolean;
  lease: number | null;
}

const newest = { at: Number.NaN, text: "" };

/** Formats a time. Many commands arrive in the same millisecond, so the last result is reused. */
function timeOf(at: number): string {
  if (at !== newest.at) Object.assign(newest, { at, text: new Date(at).toISOString() });
  return newest.text;
}

export function recordOfRow(row: CommandRow): CommandRecord {
  const { seq, key, command, state, reason, pose, distance } = row;
  return {
    seq,
    key,
    action: command.action,
    command,
    state,
    reason: reason === null ? null : reasonText(reason, row.ttl),
    acceptedAt: timeOf(row.acceptedAt),
    pose,
    distance,
    duplicate: false,
  };
}

export function termedOfRow(row: CommandRow): TermedRecord {
  const { driver, script, ttl, deadline, replace, lease } = row;
  return { record: recordOfRow(row), driver, script, ttl, deadline, replace, lease };
}

/** Robot state that determines which commands are accepted. */
export interface AdmissionState {
  epoch: number;
  lastSeq: number;
  isPaused: boolean;
  /** whether scripts may reset the robot */
  mayReset: boolean;
  /** hashes */
  keys: ReadonlySet<string>;
  /** ids of blocked scripts */
  blocked: ReadonlySet<string>;
}

/** @param before state before the change; null: the command is new */
export type OnChange = (row: CommandRow, before: CommandState | null) => void;

export class RobotCommands {
  readonly admissionState: AdmissionState;
  readonly #onChange: OnChange;
  readonly #open = new Map<number, CommandRow>();
  readonly #ended = new Map<number, CommandRow>();
  readonly #byKey = new KeyIndex<CommandRow>();
  #deletedUpTo = 0;
  #delivered = 0;
  readonly #waiting = { overtaking: 0, others: 0 };

  /** @param open the open commands, in order */
  constructor(admissionState: AdmissionState, open: readonly CommandRow[], onChange: OnChange) {
    this.admissionState = admissionState;
    this.#onChange = onChange;
    for (const row of open) this.#place(row);
  }

  /** Open commands in order, without those that end during the iteration. */
  get open(): Iterable<CommandRow> {
    return this.#open.values();
  }

  get openCount(): number {
    return this.#open.size;
  }

  /** Every command before this seq has ended. */
  get openFrom(): number {
    const [first] = this.#open.keys();
    return first ?? this.admissionState.lastSeq + 1;
  }

  /** Number of ended commands in memory. */
  get endedCount(): number {
    return this.#ended.size;
  }

  /** Commands up to this seq that had ended at the last `deleteEnded` count as deleted. */
  get deletedUpTo(): number {
    return this.#deletedUpTo;
  }

  row(seq: number): CommandRow | null {
    return this.#open.get(seq) ?? this.#ended.get(seq) ?? null;
  }

  endedRow(seq: number): CommandRow | null {
    return this.#ended.get(seq) ?? null;
  }

  /** All commands in memory, in order. */
  rows(): CommandRow[] {
    return [...this.#ended.values(), ...this.#open.values()].toSorted((a, b) => a.seq - b.seq);
  }

  /** @returns the command in memory with this key */
  withKey(driver: string, key: string): CommandRow | null {
    return this.#byKey.get(driver, key) ?? null;
  }

  /** Number of accepted commands, without those that bypass the queue. */
  get waitingCount(): number {
    return this.#waiting.others;
  }

  /** Number of delivered commands, without those that bypass the queue. */
  get deliveredCount(): number {
    return this.#delivered;
  }

  /**
   * Whether the page has as many commands as it may have, and no waiting command bypasses the
   * limit.
   */
  isWindowFull(window: number): boolean {
    return this.#delivered >= window && this.#waiting.overtaking === 0;
  }

  /** Adds a command. */
  add(row: CommandRow): CommandRow {
    this.#put(row);
    this.#onChange(row, null);
    return row;
  }

  /** Changes an open command, or shortens an ended one. */
  change(row: CommandRow, change: Partial<CommandRow>): CommandRow {
    const before = row.state;
    this.#count(row, -1);
    Object.assign(row, change);
    this.#put(row);
    this.#onChange(row, before);
    return row;
  }

  /** Sets a command to a state that is stored already. */
  restore(row: CommandRow): void {
    const before = this.#open.get(row.seq);
    if (before !== undefined) this.#count(before, -1);
    this.#put(row);
  }

  /** Deletes the commands up to this seq that have ended by now. */
  deleteEnded(seq: number): void {
    if (seq <= this.#deletedUpTo) return;
    this.#deletedUpTo = seq;
    for (const row of this.#ended.values()) if (row.seq <= seq) this.release(row);
  }

  /** Removes an ended command from memory. */
  release(row: CommandRow): void {
    this.#ended.delete(row.seq);
    const { driver, key } = row;
    // Another command may have reused the key of a deleted one.
    if (key !== null && this.#byKey.get(driver, key) === row) this.#byKey.delete(driver, key);
  }

  #put(row: CommandRow): void {
    this.#place(row);
    this.admissionState.lastSeq = Math.max(this.admissionState.lastSeq, row.seq);
  }

  #place(row: CommandRow): void {
    if (row.key !== null) this.#byKey.set(row.driver, row.key, row);
    if (!hasEnded(row.state)) {
      this.#open.set(row.seq, row);
      this.#count(row, 1);
      return;
    }
    this.#open.delete(row.seq);
    this.#ended.set(row.seq, row);
  }

  #count({ state, overtakes }: CommandRow, by: 1 | -1): void {
    if (state === "delivered" && overtakes === null) this.#delivered += by;
    if (state === "accepted") this.#waiting[overtakes === null ? "others" : "overtaking"] += by;
  }
}
