/**
 * Messages between relays that serve the same class, on one channel per class. Nothing that is
 * stored is lost without them, because a relay that missed a commit reads the class again. Every
 * implementation passes `classes/two-relays.cases.ts`.
 */
import type { ClassChanges } from "../store/class-store.ts";
import type { ClassMessage } from "./class-message.ts";
import type { ClassRecord } from "./class-record.ts";

/** A commit: the version before it, the rows that it replaces, and its events. */
export interface ClassCommit {
  kind: "changes";
  version: number;
  changes: Pick<ClassChanges, "row" | "students" | "removed">;
  events: readonly ClassRecord[];
}

export interface ClassListener {
  /** A commit of another relay. */
  committed(commit: ClassCommit): void;
  /** Another relay has deleted the class. */
  over(): void;
  /** @param from name of the other relay */
  received(message: ClassMessage, from: string): void;
  /** Messages may have been missed. */
  missed(): void;
}

export interface ClassChannel {
  /** Publishes a commit of this relay to the others, unless the store has done so. */
  committed(commit: ClassCommit): void;
  /** Publishes that this relay has deleted the class, unless the store has done so. */
  over(): void;
  /** Sends a message to the others. Delivery is not guaranteed. */
  notify(message: ClassMessage): void;
  leave(): void;
}

export interface ClassBus {
  /** Subscribes this relay to the channel of a class. */
  join(id: string, listener: ClassListener): Promise<ClassChannel>;
}
