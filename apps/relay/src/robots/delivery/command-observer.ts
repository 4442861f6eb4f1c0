/** Metrics observer of commands. It receives kinds and times, never identities. */
import type { CommandRecord } from "@corridor/protocol";

export interface CommandObserver {
  /** A command was stored this long after its arrival. */
  stored(seconds: number): void;
  /** A robot started a command this long after its arrival. */
  started(seconds: number): void;
  /** A command has ended. */
  ended(state: CommandRecord["state"]): void;
}

export const noObserver: CommandObserver = {
  stored: () => undefined,
  started: () => undefined,
  ended: () => undefined,
};
