/**
 * Storage and messaging of a relay: SQLite for a single relay, or a Redis or Valkey, which several
 * relays can share.
 */
import type { Bus } from "./bus/bus.ts";
import type { ClassBus } from "./bus/class-bus.ts";
import type { Clock } from "./platform/time/clock.ts";
import type { ClassStore } from "./store/class-store.ts";
import type { DocumentStore } from "./store/document-store.ts";
import type { PairingStore } from "./store/pairing-store.ts";
import type { RobotStore } from "./store/robot-store.ts";

export interface Backend {
  /** clock that produces and compares stored times */
  clock: Clock;
  robots: RobotStore;
  documents: DocumentStore;
  pairings: PairingStore;
  classes: ClassStore;
  bus: Bus;
  classBus: ClassBus;
  close(): Promise<void>;
}
