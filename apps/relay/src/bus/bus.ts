/**
 * Messages between relays that serve the same robot, on one channel per robot. Commands are neither
 * lost nor duplicated without them, because the store alone guarantees that. Every implementation
 * passes `bus.cases.ts`. See docs/adr/0010-multiple-relays.md.
 */
import type {
  AliveDriver,
  CommandRecord,
  Drivers,
  Marks,
  RecallCause,
  ScriptView,
} from "@corridor/protocol";
import type { CarriedSnapshot } from "./carried-snapshot.ts";
import type { TermedRecord } from "../commands/robot-commands.ts";

/** Commands that one step of the store has changed. */
export interface CommandChanges {
  /** an accepted command that waits */
  added: TermedRecord | null;
  /** new states, for readers */
  changed: CommandRecord[];
  /** commands that a relay has ended, for display on the page */
  ended: TermedRecord[];
}

/** Scripts of a robot at one relay, as its page receives them. */
export interface Scripts extends Drivers {
  /** scripts that may hold a motion */
  alive: AliveDriver[];
  /** scripts by name */
  scripts: ScriptView[];
}

/** All other messages. */
export type BusMessage =
  /** the latest snapshot, many times a second: see `Channel.sendSnapshot` */
  | { kind: "snapshot"; snapshot: CarriedSnapshot }
  /** a page has acquired the robot at another relay */
  | { kind: "page"; epoch: number; name: string }
  /**
   * that page or its relay is disconnected; closedByPage: the page closed the connection, so all of
   * its messages were received
   */
  | { kind: "page-left"; epoch: number; closedByPage: boolean }
  /** this relay sent no heartbeat for so long that the others consider its pages disconnected */
  | { kind: "lapsed" }
  /**
   * another relay holds the robot and has these scripts; `asks` requests the latest snapshot
   * immediately
   */
  | { kind: "here"; from: string; scripts: Scripts; asks: boolean }
  /** a page has connected to another relay; asks the page with this epoch to release the robot */
  | { kind: "yield"; epoch: number }
  /** that page has reported everything that it started, and starts nothing more */
  | { kind: "yielded"; epoch: number }
  /** asks the page to end this command */
  | { kind: "cancel"; seq: number; cause: RecallCause }
  /** keys or blocked scripts have changed, or may have; read them from the store */
  | { kind: "keys" }
  /** the robot's maze has changed; read it from the store */
  | { kind: "maze"; version: string }
  /** a script has marked cells of the maze; not stored */
  | { kind: "marks"; marks: Marks }
  /** the robot was deleted */
  | { kind: "over" };

export interface BusListener {
  /**
   * Changes by another relay, or by this one if the channel returns its own. All subscribers
   * receive them in the same order.
   */
  commandsChanged(changes: CommandChanges, isOwn: boolean): void;
  /** Changes may have been missed. */
  missed(): void;
  /** A message of another relay. */
  received(message: BusMessage): void;
}

export interface Channel {
  /**
   * Whether the listener also receives the changes by its own relay, in the order of all relays.
   * Otherwise the relay publishes them to its readers itself.
   */
  readonly returnsOwnChanges: boolean;
  /** Publishes changes by this relay to the others, unless the store has done so. */
  commandsChanged(changes: CommandChanges): void;
  notify(message: Exclude<BusMessage, { kind: "snapshot" }>): void;
  /**
   * Sends the latest snapshot to other relays. Delivery is not guaranteed.
   * @param relays names with which they announced themselves; a bus in one process sends to all
   */
  sendSnapshot(snapshot: CarriedSnapshot, relays: Iterable<string>): void;
  /** Flushes pending messages, so that they precede the next step of the store. */
  flush(): void;
  leave(): void;
}

export interface Bus {
  /**
   * Subscribes this relay to a robot's channel. If a page owns the robot at another relay, the
   * subscriber receives that before the promise resolves.
   */
  join(robot: string, listener: BusListener): Promise<Channel>;
  close(): Promise<void>;
}
