/**
 * The commands of scripts in a run, with start, end and ending, and the waiting time between them.
 * Commands are plain objects, because the inputs of the run need more memory for the same commands.
 */
import type { Command, EndingState } from "@corridor/protocol";
import { GrowingArray } from "./growing-array.ts";

/** A command of a script, in ticks of the run. */
export interface TimelineCommand {
  /** number of the command at the relay, from 1 */
  seq: number;
  command: Command;
  /** tick at whose end the command started */
  from: number;
  /** tick at whose end the command ended; null while it runs */
  to: number | null;
  /** null while the command runs */
  ending: EndingState | null;
}

/** Changes of a command log since the last `takeDelta`. */
export interface CommandDelta {
  /** number of unchanged commands; the commands of the delta replace the following ones */
  unchangedCommands: number;
  commands: TimelineCommand[];
  /** number of unchanged starts and ends of waiting */
  unchangedWaits: number;
  waitTicks: Int32Array<ArrayBuffer>;
  waitSums: Int32Array<ArrayBuffer>;
}

/** Approximate size of one command in bytes. */
const COMMAND_BYTES = 160;

export class CommandLog {
  readonly #commands: TimelineCommand[] = [];
  /** Ticks at which waiting starts (even index) and ends (odd index). */
  readonly #waitTicks = new GrowingArray("int32");
  /** Total waiting time up to each of these ticks, in ticks. */
  readonly #waitSums = new GrowingArray("int32");
  /**
   * Number of entries unchanged since the last `takeDelta`, and number of entries at that time; -1
   * before the first, which empties a copy that has the entries of another run.
   */
  #unchangedCommands = 0;
  #unchangedWaits = 0;
  #sentCommands = -1;
  #sentWaits = -1;

  get count(): number {
    return this.#commands.length;
  }

  /** Approximate memory use in bytes. */
  get byteLength(): number {
    const waits = this.#waitTicks.byteLength + this.#waitSums.byteLength;
    return waits + this.#commands.length * COMMAND_BYTES;
  }

  /** Returns command `index`, in time order. */
  at(index: number): TimelineCommand | undefined {
    return this.#commands[index];
  }

  /**
   * Number of commands up to the end of `tick`, which is the index of the first command after it.
   */
  countUpTo(tick: number): number {
    let low = 0;
    let high = this.#commands.length;
    while (low < high) {
      const middle = (low + high) >>> 1;
      if ((this.#commands[middle]?.from ?? Infinity) <= tick) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /**
   * Number of ticks up to the end of `tick` in which a script was the driver but no command ran.
   */
  waitedUpTo(tick: number): number {
    const count = this.#waitTicks.countUpTo(tick);
    if (count === 0) return 0;
    const sum = this.#waitSums.at(count - 1);
    const isWaiting = count % 2 === 1;
    return isWaiting ? sum + tick - this.#waitTicks.at(count - 1) : sum;
  }

  recordStart(seq: number, command: Command, tick: number): void {
    this.#commands.push({ seq, command, from: tick, to: null, ending: null });
  }

  /** Ends the running command. Does nothing if no command runs. */
  recordEnd(tick: number, ending: EndingState): void {
    const index = this.#commands.length - 1;
    const last = this.#commands[index];
    if (last?.to !== null) return;
    this.#commands[index] = { ...last, to: tick, ending };
    this.#unchangedCommands = Math.min(this.#unchangedCommands, index);
  }

  /** Records whether the robot waits for a command from the end of `tick` on. */
  setWaiting(tick: number, isWaiting: boolean): void {
    if (isWaiting === (this.#waitTicks.length % 2 === 1)) return;
    this.#waitSums.push(this.waitedUpTo(tick));
    this.#waitTicks.push(tick);
  }

  /**
   * Deletes entries after the end of `tick`. A command that ended after it becomes the running one.
   */
  truncateAfter(tick: number): void {
    this.#commands.length = this.countUpTo(tick);
    const index = this.#commands.length - 1;
    const last = this.#commands[index];
    this.#unchangedCommands = Math.min(this.#unchangedCommands, index + 1);
    if (last !== undefined && last.to !== null && last.to > tick) {
      this.#commands[index] = { ...last, to: null, ending: null };
      this.#unchangedCommands = Math.min(this.#unchangedCommands, index);
    }
    const waits = this.#waitTicks.countUpTo(tick - 1);
    this.#waitTicks.truncate(waits);
    this.#waitSums.truncate(waits);
    this.#unchangedWaits = Math.min(this.#unchangedWaits, waits);
  }

  /** Returns the changes since the last call, or null. */
  takeDelta(): CommandDelta | null {
    const isSame =
      this.#unchangedCommands === this.count &&
      this.#sentCommands === this.count &&
      this.#unchangedWaits === this.#waitTicks.length &&
      this.#sentWaits === this.#waitTicks.length;
    if (isSame) return null;
    const delta: CommandDelta = {
      unchangedCommands: this.#unchangedCommands,
      commands: this.#commands.slice(this.#unchangedCommands),
      unchangedWaits: this.#unchangedWaits,
      waitTicks: this.#waitTicks.copyFrom(this.#unchangedWaits),
      waitSums: this.#waitSums.copyFrom(this.#unchangedWaits),
    };
    this.#unchangedCommands = this.#sentCommands = this.count;
    this.#unchangedWaits = this.#sentWaits = this.#waitTicks.length;
    return delta;
  }

  /** Applies the changes of another log. */
  applyDelta(delta: CommandDelta): void {
    this.#commands.length = Math.min(this.count, delta.unchangedCommands);
    for (const command of delta.commands) this.#commands.push(command);
    this.#waitTicks.replaceFrom(delta.unchangedWaits, delta.waitTicks);
    this.#waitSums.replaceFrom(delta.unchangedWaits, delta.waitSums);
  }
}
