/**
 * Robots in Redis or Valkey, which several relays can share. A step applies the rules to
 * the robot in memory and commits the changes, together with the messages on the robot's channel,
 * by `commit.lua`, if no other relay has changed the robot since.
 */
import type { CommandRecord, Ending, RecallCause } from "@corridor/protocol";
import { z } from "zod";
import { recordOfRow, type CommandRow } from "../../commands/command-row.ts";
import { changeBlocked, changeKeys } from "../../commands/permissions.ts";
import * as machine from "../../commands/state-machine.ts";
import { StoreFull } from "../../platform/errors/disk-full.ts";
import type {
  AddResult,
  BlockResult,
  CancelResult,
  EndResult,
  KeyChange,
  KeysResult,
  KeyTimes,
  KeyUse,
  NewCommand,
  PageState,
  ScriptChange,
  RobotStore,
  StoredRobot,
  TermedRecord,
} from "../port.ts";
import { asked, type Redis } from "./connection.ts";
import {
  endedForPage,
  endedRow,
  endedWithKey,
  storedAfter,
  storedOpen,
  storedRow,
} from "./ended-commands.ts";
import type { DeletedBytes } from "./deleted-bytes.ts";
import { keyMember } from "./loaded-robot.ts";
import { BIRTHS, robotKeyOf, USES } from "./redis-keys.ts";
import { RobotCommits } from "./robot-commits.ts";
import { Script } from "./script.ts";
import { isHeldElsewhere, keyTimesIn, madeAt, robotIn, usedAt, usesIn } from "./stored-robots.ts";

/** Robots to delete per step, because each step blocks Redis. */
const MOST_AT_ONCE = 200;

type Acquired = Awaited<ReturnType<RobotStore["acquire"]>>;

export class RedisRobotStore implements RobotStore {
  readonly #redis: Redis;
  readonly #relay: string;
  readonly #robots: RobotCommits;
  readonly #read: Script;
  readonly #deletion: Script;
  readonly #deletedBytes: DeletedBytes;

  /**
   * @param redis closed by the caller
   * @param relay name of this relay, by which it recognises its own steps on the channel
   * @param most robots to keep in memory
   */
  constructor(redis: Redis, deletedBytes: DeletedBytes, relay: string, most?: number) {
    this.#redis = redis;
    this.#relay = relay;
    this.#robots = new RobotCommits(redis, relay, most);
    this.#read = new Script(redis, "read.lua");
    this.#deletion = new Script(redis, "deletion.lua", [relay]);
    this.#deletedBytes = deletedBytes;
  }

  async create({
    id,
    createdAt,
    keys,
  }: Omit<StoredRobot, "epoch" | "page" | "lastUsedAt" | "blocked" | "isPaused">) {
    const at = String(createdAt);
    const made = keys.flatMap(({ hash }) => [madeAt(hash), at]);
    const fields = ["epoch", "0", "seq", "0", "createdAt", at, "keys", JSON.stringify(keys)];
    await this.#robots.create(id, [
      ["HSET", robotKeyOf(id), ...fields, ...made],
      ["ZADD", USES, at, id],
      ["ZADD", BIRTHS, at, id],
    ]);
  }

  async find(id: string): Promise<StoredRobot | null> {
    return robotIn(this.#read, id);
  }

  changeKeys(id: string, change: KeyChange): Promise<KeysResult> {
    return this.#robots.run<KeysResult>(id, {
      none: { outcome: "no-robot" },
      work: (robot) => {
        const before = robot.permissions;
        const changed = changeKeys(robot.commands, before, change);
        if (changed === null) return { outcome: "full" };
        const { keys, blocked, revoked, ended } = changed;
        robot.permissions = { keys, blocked };
        const made = change.add.map(({ hash }) => [madeAt(hash), String(change.now)]);
        const texts = { keys: JSON.stringify(keys), blocked: JSON.stringify(blocked) };
        robot.set({ ...texts, ...Object.fromEntries(made) });
        const times = revoked.flatMap((hash) => [madeAt(hash), usedAt(hash)]);
        const isAdded = (field: string): boolean => made.some(([added]) => added === field);
        const gone = times.filter((field) => !isAdded(field));
        if (gone.length > 0) robot.also("HDEL", robotKeyOf(id), ...gone);
        robot.publish({ kind: "keys" });
        return { outcome: "changed", keys, ended };
      },
    });
  }

  changeBlocked(id: string, change: ScriptChange): Promise<BlockResult> {
    return this.#robots.run<BlockResult>(id, {
      none: { outcome: "no-robot" },
      work: (robot) => {
        const changed = changeBlocked(robot.commands, robot.permissions.blocked, change);
        if (changed === null) return { outcome: "full" };
        robot.permissions = { ...robot.permissions, blocked: changed.blocked };
        robot.set({ blocked: JSON.stringify(changed.blocked) });
        robot.publish({ kind: "keys" });
        return { outcome: "changed", ...changed };
      },
    });
  }

  pause(id: string, isPaused: boolean): Promise<TermedRecord[] | null> {
    return this.#robots.run<TermedRecord[] | null>(id, {
      none: null,
      work: (robot) => {
        robot.publish({ kind: "keys" });
        return machine.pause(robot.commands, isPaused);
      },
    });
  }

  storeMaze(id: string, text: string): Promise<boolean> {
    return this.#robots.run(id, {
      none: false,
      work: (robot) => {
        robot.set({ maze: text });
        return true;
      },
    });
  }

  async maze(id: string): Promise<string | null> {
    return (await asked(this.#redis.hGet(robotKeyOf(id), "maze"))) ?? null;
  }

  async keyTimes(id: string): Promise<KeyTimes[]> {
    return keyTimesIn(this.#redis, id);
  }

  touch(id: string, now: number, keys: readonly KeyUse[]): Promise<void> {
    const hashes = keys.map(({ hash }) => hash);
    return this.#robots.run(id, {
      none: undefined,
      read: () => (hashes.length === 0 ? null : usesIn(this.#redis, id, hashes)),
      work: (robot, used) => {
        robot.also("ZADD", USES, "XX", "GT", String(now), id);
        for (const { hash, at } of keys) {
          const isKey = robot.commands.accessState.keys.has(hash);
          if (isKey && at > (used?.get(hash) ?? 0)) robot.set({ [usedAt(hash)]: String(at) });
        }
      },
    });
  }

  async remove(id: string): Promise<boolean> {
    const removed = z.boolean().parse(await this.#delete("remove", { id }));
    this.#robots.drop([id]);
    if (removed) await this.#deletedBytes.sweep();
    return removed;
  }

  async removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]> {
    const all: string[] = [];
    for (;;) {
      const values = { ...before, most: MOST_AT_ONCE };
      const ids = z.array(z.string()).parse(await this.#delete("removeExpired", values));
      all.push(...ids);
      if (ids.length < MOST_AT_ONCE) break;
    }
    this.#robots.drop(all);
    if (all.length > 0) await this.#deletedBytes.sweep();
    return all;
  }

  add(id: string, command: NewCommand): Promise<AddResult> {
    const { driver, key } = command;
    return this.#robots.run<AddResult, CommandRow>(id, {
      none: { outcome: "no-robot" },
      // Most keys are new, which the commit checks.
      read: (_robot, isPresent) =>
        key !== null && isPresent ? endedWithKey(this.#redis, id, { driver, key }) : null,
      absent: ({ commands }, earlier) =>
        key === null || earlier !== null || commands.withKey(driver, key) !== null
          ? null
          : keyMember(driver, key),
      work: ({ commands }, earlier) =>
        machine.add(commands, command, (...named) => commands.withKey(...named) ?? earlier),
    });
  }

  deliver(id: string, epoch: number, window: number, now: number): Promise<TermedRecord[]> {
    return this.#robots.run<TermedRecord[]>(id, {
      none: [],
      work: ({ commands }) => machine.deliver(commands, { epoch, window, now }),
    });
  }

  /** Always false: another relay may have changed the robot. */
  hasAll(): boolean {
    return false;
  }

  expire(
    id: string,
    now: number,
    isAbsent?: boolean,
  ): Promise<{ ended: TermedRecord[]; next: number | null }> {
    return this.#robots.run<{ ended: TermedRecord[]; next: number | null }>(id, {
      none: { ended: [], next: null },
      work: ({ commands }) => machine.expire(commands, now, isAbsent),
    });
  }

  cancel(id: string, seq: number, driver: string): Promise<CancelResult> {
    return this.#robots.run<CancelResult, CommandRow>(id, {
      none: { outcome: "no-command" },
      read: ({ commands }) => (commands.row(seq) === null ? endedRow(this.#redis, id, seq) : null),
      work: ({ commands }, ended) => machine.cancel(commands, commands.row(seq) ?? ended, driver),
    });
  }

  start(id: string, epoch: number, seq: number): Promise<CommandRecord | null> {
    return this.#robots.run<CommandRecord | null>(id, {
      none: null,
      work: ({ commands }) => machine.start(commands, epoch, seq),
    });
  }

  end(id: string, epoch: number, ending: Ending): Promise<EndResult> {
    const { seq } = ending;
    return this.#robots.run<EndResult, CommandRow>(id, {
      none: { outcome: "over", record: null },
      read: ({ commands }) => (commands.row(seq) === null ? endedRow(this.#redis, id, seq) : null),
      work: ({ commands }, ended) =>
        machine.end(commands, epoch, ending, () => commands.row(seq) ?? ended),
    });
  }

  abandon(id: string, epoch: number): Promise<CommandRecord[] | null> {
    return this.#robots.run<CommandRecord[] | null, boolean>(id, {
      none: [],
      read: ({ commands }) =>
        commands.accessState.epoch === epoch ? isHeldElsewhere(this.#redis, id, this.#relay) : null,
      work: ({ commands }, isHeld) => (isHeld === true ? null : machine.abandon(commands, epoch)),
    });
  }

  acquire(id: string, page: PageState): Promise<Acquired> {
    return this.#robots.run<Acquired, CommandRow[]>(id, {
      none: null,
      read: ({ commands }) => endedForPage(this.#redis, id, { commands, page }),
      work: (robot, ended) => {
        const rows = (): CommandRow[] => [...robot.commands.rows(), ...(ended ?? [])];
        const taken = machine.acquire(robot.commands, page, {
          row: (seq) => rows().find((row) => row.seq === seq) ?? null,
          newest: (what, after) => machine.newestOvertaking(rows(), what, after),
        });
        const { epoch } = taken;
        const { page: name = "" } = page;
        robot.set({ page: JSON.stringify({ relay: this.#relay, epoch, name }), name });
        robot.publish({ kind: "page", epoch, name });
        return taken;
      },
    });
  }

  async command(id: string, seq: number): Promise<CommandRecord | null> {
    const row = await storedRow(this.#read, id, seq);
    return row && recordOfRow(row);
  }

  async commandsAfter(id: string, seq: number, limit: number): Promise<CommandRecord[]> {
    return (await storedAfter(this.#read, id, { seq, limit })).map(recordOfRow);
  }

  async openCommands(id: string): Promise<CommandRecord[]> {
    return (await storedOpen(this.#redis, id)).map(recordOfRow);
  }

  async recalled(id: string): Promise<{ seq: number; cause: RecallCause }[]> {
    return machine.recalled(await storedOpen(this.#redis, id));
  }

  async check(): Promise<"ok" | "full"> {
    try {
      await asked(this.#redis.set("corridor:check", "written"));
      return "ok";
    } catch (error) {
      if (error instanceof StoreFull) return "full";
      throw error;
    }
  }

  async close(): Promise<void> {
    // Other stores share the connection.
  }

  async #delete(step: string, values: unknown): Promise<unknown> {
    return this.#deletion.run(step, [USES, BIRTHS], values);
  }
}
