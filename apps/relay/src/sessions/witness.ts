/** Whoever counts what happens to commands. It is told kinds and times, never whose they are. */
import type { CommandRecord } from "@corridor/protocol";

export interface Witness {
  /** A command was stored so long after it came. */
  stored(seconds: number): void;
  /** A robot has started a command so long after it came. */
  started(seconds: number): void;
  /** A command has ended. */
  ended(state: CommandRecord["state"]): void;
}

export const noWitness: Witness = {
  stored: () => undefined,
  started: () => undefined,
  ended: () => undefined,
};
