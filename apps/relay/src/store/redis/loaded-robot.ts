/**
 * A robot as loaded from Redis: its state and open commands, and the changes that a step makes to
 * them. Ended commands stay in Redis; a step that needs some reads them first.
 */
import { hasEnded } from "@corridor/protocol";
import { z } from "zod";
import {
  type AdmissionState,
  type CommandRow,
  type Overtaking,
  RobotCommands,
} from "../../commands/robot-commands.ts";
import { newestOvertaking } from "../../commands/page-transitions.ts";
import { admissionStateOf } from "../../commands/permissions.ts";
import type {
  KeysChange,
  RobotState,
  SeqRange,
  Permissions,
  StoredScript,
} from "../../commands/robot-step.ts";
import { endedOf, keysOf, channelOf, madeAt, openOf, robotKeyOf, usedAt } from "./redis-keys.ts";
import { rowIn, textOf } from "./rows.ts";
import { blockedText, keysText } from "./permission-texts.ts";
import type { Words } from "./words.ts";

/** The answer of commit.lua with the current robot. */
export const robotAnswer = z.tuple([
  z.tuple([
    z.string(),
    z.coerce.number(),
    z.coerce.number(),
    z.coerce.number(),
    keysText,
    blockedText.nullable(),
    z.string().nullable(),
    z.string().nullable(),
  ]),
  z.array(z.string()),
]);

/** The member of the index by idempotency key. */
export function keyMember(driver: string, key: string): string {
  return `${driver}:${key}`;
}

/** What was read for a step. */
export interface Found {
  /** ended commands */
  rows: readonly CommandRow[];
  isHeldElsewhere: boolean;
}

export const nothingFound: Found = { rows: [], isHeldElsewhere: false };

export class LoadedRobot implements RobotState {
  readonly commands: RobotCommands;
  permissions: Permissions;
  /** what was read for the current step */
  found = nothingFound;
  version: string;
  readonly #id: string;
  readonly #relay: string;
  /** number of the last step on the robot's channel */
  #n: number;
  #stored: Omit<AdmissionState, "keys" | "blocked"> & { deletedUpTo: number };
  readonly #rows = new Map<number, CommandRow>();
  /** seqs of rows that had ended before */
  readonly #rewritten = new Set<number>();
  /** new states, for the subscribers of the channel */
  readonly #changed = new Map<number, CommandRow>();
  #added: CommandRow | null = null;
  #also: Words[] = [];
  #messages: string[] = [];
  /** whether other relays must read the permissions again */
  #hasNewRights = false;

  constructor(id: string, relay: string, answer: z.output<typeof robotAnswer>) {
    const [[version, epoch, lastSeq, n, keys, blocked, paused, mayReset], open] = answer;
    const state = { epoch, lastSeq, isPaused: paused === "1", mayReset: mayReset !== "0" };
    this.#id = id;
    this.#relay = relay;
    this.version = version;
    this.#n = n;
    this.permissions = { keys, blocked: blocked ?? [] };
    this.#stored = { ...state, deletedUpTo: 0 };
    const rows = open.map(rowIn).toSorted((a, b) => a.seq - b.seq);
    const admissionState = { ...state, ...admissionStateOf(this.permissions) };
    this.commands = new RobotCommands(admissionState, rows, (row, before) => {
      this.#rows.set(row.seq, row);
      if (before !== null && hasEnded(before)) this.#rewritten.add(row.seq);
      if (before === null) this.#added = row;
      else if (before !== row.state) this.#changed.set(row.seq, row);
    });
  }

  get isHeldElsewhere(): boolean {
    return this.found.isHeldElsewhere;
  }

  row(seq: number): CommandRow | null {
    return this.commands.row(seq) ?? this.found.rows.find((row) => row.seq === seq) ?? null;
  }

  withKey(driver: string, key: string): CommandRow | null {
    const isMeant = (row: CommandRow): boolean => row.driver === driver && row.key === key;
    return this.commands.withKey(driver, key) ?? this.found.rows.find(isMeant) ?? null;
  }

  ended({ after, upTo }: SeqRange): CommandRow[] {
    const isMeant = ({ seq, state }: CommandRow): boolean =>
      seq > after && seq <= upTo && hasEnded(state);
    return this.found.rows.filter(isMeant);
  }

  newest(overtakes: Overtaking, after: number): number | null {
    return newestOvertaking([...this.commands.rows(), ...this.found.rows], overtakes, after);
  }

  setKeys({ keys, added, revoked, now }: KeysChange): void {
    this.permissions = { ...this.permissions, keys };
    const made = added.map(({ hash }) => [madeAt(hash), String(now)]);
    this.set({ keys: JSON.stringify(keys), ...Object.fromEntries(made) });
    const times = revoked.flatMap((hash) => [madeAt(hash), usedAt(hash)]);
    const gone = times.filter((field) => !made.some(([madeField]) => madeField === field));
    if (gone.length > 0) this.also("HDEL", robotKeyOf(this.#id), ...gone);
    this.#hasNewRights = true;
  }

  setBlocked(blocked: readonly StoredScript[]): void {
    this.permissions = { ...this.permissions, blocked: [...blocked] };
    this.set({ blocked: JSON.stringify(blocked) });
    this.#hasNewRights = true;
  }

  setPage(name: string): void {
    const { epoch } = this.commands.admissionState;
    this.set({ page: JSON.stringify({ relay: this.#relay, epoch, name }), name });
    this.#publish({ kind: "page", epoch, name });
  }

  /** Adds fields of the robot to the changes. */
  set(fields: Record<string, string>): void {
    this.#also.push(["HSET", robotKeyOf(this.#id), ...Object.entries(fields).flat()]);
  }

  /** Adds a Redis command to the changes. */
  also(...words: Words): void {
    this.#also.push(words);
  }

  /** Adds a message to other relays, before that of the step. */
  #publish(message: { kind: string; epoch?: number; name?: string }): void {
    this.#messages.push(JSON.stringify({ ...message, from: this.#relay }));
  }

  /** The changes of a step as Redis commands. Releases ended commands from memory. */
  take(): Words[] {
    const changes = [...this.#also, ...this.#ofRows(), ...this.#ofAdmissionState()];
    if (this.#hasNewRights) this.#publish({ kind: "keys" });
    const step = this.#stepMessage();
    if (step !== null) {
      changes.push(["HSET", robotKeyOf(this.#id), "n", String(this.#n)]);
      this.#messages.push(step);
    }
    for (const text of this.#messages) changes.push(["PUBLISH", channelOf(this.#id), text]);
    for (const row of this.#rows.values()) if (hasEnded(row.state)) this.commands.release(row);
    this.#rows.clear();
    this.#rewritten.clear();
    this.#changed.clear();
    this.#added = null;
    this.#also = [];
    this.#messages = [];
    this.#hasNewRights = false;
    this.found = nothingFound;
    return changes;
  }

  #ofRows(): Words[] {
    const [open, ended, keys] = [openOf(this.#id), endedOf(this.#id), keysOf(this.#id)];
    const changes = [...this.#rows.values()].flatMap((row): Words[] => {
      const seq = String(row.seq);
      if (!hasEnded(row.state)) return [["HSET", open, seq, textOf(row)]];
      const { driver, key } = row;
      const ofKey: Words[] = key === null ? [] : [["ZADD", keys, seq, keyMember(driver, key)]];
      const added: Words = ["ZADD", ended, seq, textOf(row)];
      if (this.#rewritten.has(row.seq)) return [["ZREMRANGEBYSCORE", ended, seq, seq], added];
      return [added, ["HDEL", open, seq], ...ofKey];
    });
    const { deletedUpTo } = this.commands;
    if (deletedUpTo > this.#stored.deletedUpTo) {
      // Commands that end in this step may be deleted by it, too.
      for (const key of [ended, keys])
        changes.push(["ZREMRANGEBYSCORE", key, "-inf", String(deletedUpTo)]);
    }
    return changes;
  }

  #ofAdmissionState(): Words[] {
    const { epoch, lastSeq, isPaused, mayReset } = this.commands.admissionState;
    const before = this.#stored;
    const { deletedUpTo } = this.commands;
    this.#stored = { epoch, lastSeq, isPaused, mayReset, deletedUpTo };
    const fields: string[] = [];
    if (epoch !== before.epoch) fields.push("epoch", String(epoch));
    if (lastSeq !== before.lastSeq) fields.push("seq", String(lastSeq));
    if (isPaused !== before.isPaused) {
      fields.push("paused", isPaused ? "1" : "0");
      this.#hasNewRights = true;
    }
    if (mayReset !== before.mayReset) {
      fields.push("mayReset", mayReset ? "1" : "0");
      this.#hasNewRights = true;
    }
    return fields.length === 0 ? [] : [["HSET", robotKeyOf(this.#id), ...fields]];
  }

  /** The message about the changed commands, which lists them in order; null: there are none. */
  #stepMessage(): string | null {
    if (this.#added === null && this.#changed.size === 0) return null;
    this.#n += 1;
    const rows = [...this.#changed.values()].toSorted((a, b) => a.seq - b.seq);
    const added = this.#added === null ? "null" : textOf(this.#added);
    const head = JSON.stringify({ kind: "step", n: this.#n, from: this.#relay }).slice(0, -1);
    return `${head},"added":${added},"changed":[${rows.map(textOf).join(",")}]}`;
  }
}
