/**
 * Messages between relays that serve the same class, on one channel per class. Nothing that is
 * stored is lost without them, because a relay that missed a commit reads the class again. Every
 * implementation passes `class-bus.cases.ts`.
 */
import type { ProgressRecord, StudentTile, StudentView } from "@corridor/protocol";
import type { ClassChanges } from "../store/class-store.ts";

/** An event for dashboards, without its number. */
export type ClassRecord =
  | { type: "student"; student: StudentView; progress: ProgressRecord | null }
  | { type: "removed"; student: number };

/** A commit: the version before it, the rows that it replaces, and its events. */
export interface ClassNews {
  kind: "changes";
  version: number;
  changes: Pick<ClassChanges, "row" | "students" | "removed">;
  events: readonly ClassRecord[];
}

/** All other messages. */
export type ClassMessage =
  /** the students that are connected and watched there; `asks` requests the same of the others */
  | { kind: "here"; connected: number[]; watched: number[]; asks: boolean }
  /** a student has connected there: an earlier connection ends */
  | { kind: "connected"; student: number }
  /** newest tiles of the students there */
  | { kind: "tiles"; tiles: StudentTile[] }
  | { kind: "hint"; student: number; task: number; hint: number }
  /** for big screens */
  | { kind: "display"; content: Record<string, unknown> }
  /** the relay does not hold the class any more */
  | { kind: "left" }
  /** the class was deleted */
  | { kind: "over" };

export interface ClassListener {
  /** A commit of another relay. */
  news(news: ClassNews): void;
  /** A message of another relay. */
  received(message: ClassMessage, from: string): void;
  /** Messages may have been missed. */
  missed(): void;
}

export interface ClassChannel {
  /** Publishes a commit of this relay to the others, unless the store has done so. */
  committed(news: ClassNews): void;
  notify(message: ClassMessage): void;
  leave(): void;
}

export interface ClassBus {
  /** Subscribes this relay to the channel of a class. */
  join(id: string, listener: ClassListener): Promise<ClassChannel>;
}
