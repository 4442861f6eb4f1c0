/**
 * Robots in Redis or Valkey, which several relays can share. A step applies the rules to
 * the robot in memory and commits the changes, together with the messages on the robot's channel,
 * by `commit.lua`, if no other relay has changed the robot since.
 */
import type { CommandRecord } from "@corridor/protocol";
import { z } from "zod";
import { recordOfRow } from "../../commands/robot-commands.ts";
import type { RobotStep } from "../../commands/robot-step.ts";
import { StoreFull } from "../../platform/errors/disk-full.ts";
import type { KeyTimes, KeyUse, NewRobot, RobotStore, StoredRobot } from "../robot-store.ts";
import { asked, type Redis } from "./connection.ts";
import { lookUp, storedAfter, storedCommand, storedOpen } from "./ended-commands.ts";
import type { DeletedBytes } from "./deleted-bytes.ts";
import { keyMember, nothingFound, type Found } from "./loaded-robot.ts";
import { BIRTHS, madeAt, robotKeyOf, usedAt, USES } from "./redis-keys.ts";
import { removeExpired } from "./remove-expired.ts";
import { RobotCommits } from "./robot-commits.ts";
import { Script } from "./script.ts";
import { keyTimesIn, robotIn, usesIn } from "./stored-robots.ts";

export class RedisRobotStore implements RobotStore {
  readonly #redis: Redis;
  readonly #relay: string;
  readonly #robots: RobotCommits;
  readonly #read: Script;
  readonly #holders: Script;
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
    this.#read = new Script(redis, ["read.lua"]);
    this.#holders = new Script(redis, ["page-holders.lua"], [relay]);
    this.#deletion = new Script(redis, ["expiry.lua", "deletion.lua"], [relay]);
    this.#deletedBytes = deletedBytes;
  }

  async create({ id, createdAt, keys }: NewRobot): Promise<void> {
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

  commit<T>(id: string, step: RobotStep<T>): Promise<T> {
    return this.#robots.run<T, Found>(id, {
      none: step.none,
      read: ({ commands }, isPresent) => {
        const lookup = step.lookup?.(commands);
        const where = {
          redis: this.#redis,
          holders: this.#holders,
          id,
          relay: this.#relay,
        };
        // Most keys are new, which the commit checks.
        return lookup === undefined ? null : lookUp(where, commands, { ...lookup, isPresent });
      },
      absent: (robot, found) => {
        const key = step.lookup?.(robot.commands).key ?? null;
        if (key === null) return null;
        robot.found = found ?? nothingFound;
        return robot.withKey(key.driver, key.key) === null ? keyMember(key.driver, key.key) : null;
      },
      work: (robot, found) => {
        robot.found = found ?? nothingFound;
        return step.apply(robot);
      },
    });
  }

  /** Always null: another relay may have changed the robot. */
  current(): null {
    return null;
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
          const isKey = robot.commands.admissionState.keys.has(hash);
          if (isKey && at > (used?.get(hash) ?? 0)) robot.set({ [usedAt(hash)]: String(at) });
        }
      },
    });
  }

  async remove(id: string): Promise<boolean> {
    const removed = z.boolean().parse(await this.#delete("remove", { id }));
    this.#robots.drop([id]);
    if (removed) this.#deletedBytes.deleted();
    await this.#deletedBytes.sweep();
    return removed;
  }

  async removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]> {
    const all = await removeExpired(before, async (values) =>
      this.#delete("removeExpired", values),
    );
    this.#robots.drop(all);
    if (all.length > 0) this.#deletedBytes.deleted();
    await this.#deletedBytes.sweep();
    return all;
  }

  async command(id: string, seq: number): Promise<CommandRecord | null> {
    return storedCommand(this.#read, id, seq);
  }

  async commandsAfter(id: string, seq: number, limit: number): Promise<CommandRecord[]> {
    return storedAfter(this.#read, id, { seq, limit });
  }

  async openCommands(id: string): Promise<CommandRecord[]> {
    return (await storedOpen(this.#redis, id)).map(recordOfRow);
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
