/**
 * Storage of the relay: robots, their hashed keys and the state of every command.
 *
 * Each method is atomic, so that several relays can share a store. All rules of commands and
 * permissions are steps, which `commit` applies. Times are wall-clock milliseconds since 1970. Every
 * implementation passes `cases/store.cases.ts`.
 */
import type { CommandRecord } from "@corridor/protocol";
import type { RobotCommands } from "../commands/robot-commands.ts";
import type { RobotStep, StoredKey, StoredScript } from "../commands/robot-step.ts";

/** When a key was created and last used, as far as recorded; null: never used. */
export interface KeyTimes {
  hash: string;
  createdAt: number;
  lastUsedAt: number | null;
}

/** A use of a key. */
export interface KeyUse {
  hash: string;
  at: number;
}

export interface StoredRobot {
  id: string;
  /** incremented each time a page acquires the robot; 0 before the first */
  epoch: number;
  /**
   * id by which the last owning page identifies itself on each connection; empty if it sent none
   */
  page: string;
  createdAt: number;
  lastUsedAt: number;
  keys: StoredKey[];
  blocked: StoredScript[];
  /** the owner has paused all scripts */
  isPaused: boolean;
  /** scripts may reset the robot */
  mayReset: boolean;
}

/** What the store sets itself when a robot is created. */
type InitialState = "epoch" | "page" | "lastUsedAt" | "blocked" | "isPaused" | "mayReset";
export type NewRobot = Omit<StoredRobot, InitialState>;

export interface RobotStore {
  create(robot: NewRobot): Promise<void>;
  find(id: string): Promise<StoredRobot | null>;
  /**
   * Applies a step to the robot and stores what it changes, if nothing has changed the robot since:
   * otherwise it repeats the step. Steps of a robot run in the order of the calls. The rules are in
   * `../commands`.
   * @throws StoreUnavailableError if it is unknown whether the step took effect
   */
  commit<T>(id: string, step: RobotStep<T>): Promise<T>;
  /** The robot's commands, if they are known without a query; otherwise null. */
  current(id: string): Pick<RobotCommands, "isWindowFull"> | null;
  /**
   * Stores the maze that the robot is in, in place of the previous one.
   * @param text the document as JSON
   * @returns false if there is no such robot
   */
  storeMaze(id: string, text: string): Promise<boolean>;
  /** The maze that the robot is in; null if none is stored. */
  maze(id: string): Promise<string | null>;
  /** Times of the robot's keys, in no particular order. */
  keyTimes(id: string): Promise<KeyTimes[]>;
  /** Records a use of the robot and of its keys. Times never decrease. */
  touch(id: string, now: number, keys: readonly KeyUse[]): Promise<void>;
  /** Deletes the robot and all of its data. @returns false if there was none */
  remove(id: string): Promise<boolean>;
  /** Deletes robots last used or created before these times. @returns their ids */
  removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]>;

  command(id: string, seq: number): Promise<CommandRecord | null>;
  /** Commands with a higher seq, in order. */
  commandsAfter(id: string, seq: number, limit: number): Promise<CommandRecord[]>;
  /** The commands that have not ended, in order. */
  openCommands(id: string): Promise<CommandRecord[]>;
  /**
   * Checks whether the store is writable, by writing.
   * @returns full: it responds, but has no free space
   * @throws Error if it does not respond
   */
  check(): Promise<"ok" | "full">;
  close(): Promise<void>;
}
