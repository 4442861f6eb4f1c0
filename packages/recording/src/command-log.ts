/**
 * The commands of scripts in a run: when each began and ended, and how; and how long the robot waited
 * for the next one. Plain objects: the inputs of the run, which hold the same commands, cost more.
 */
import type { Command, EndingState } from "@corridor/protocol";
import { GrowingArray } from "./growing-array.ts";

/** A command of a script, in ticks of the run. */
export interface TimelineCommand {
  /** its number at the relay, from 1 */
  seq: number;
  command: Command;
  /** tick at whose end it began */
  from: number;
  /** tick at whose end it ended; null while it runs */
  to: number | null;
  /** null while it runs */
  ending: EndingState | null;
}

/** What a command log gained or lost since the last `take`. */
export interface CommandDelta {
  /** commands that stay as they were; those after them are replaced */
  unchangedCommands: number;
  commands: TimelineCommand[];
  /** changes between driving and waiting that stay as they were */
  unchangedWaits: number;
  waitTicks: Int32Array<ArrayBuffer>;
  waitSums: Int32Array<ArrayBuffer>;
}

/** Bytes of one command, roughly. */
const COMMAND_BYTES = 160;

export class CommandLog {
  readonly #commands: TimelineCommand[] = [];
  /** Ticks at which waiting begins (even index) and ends (odd index). */
  readonly #waitTicks = new GrowingArray("int32");
  /** Ticks waited up to each of them. */
  readonly #waitSums = new GrowingArray("int32");
  /** commands and changes that are as they were at the last `take`, and how many there were then */
  #unchangedCommands = 0;
  #unchangedWaits = 0;
  #sentCommands = 0;
  #sentWaits = 0;

  get count(): number {
    return this.#commands.length;
  }

  /** Bytes held, roughly. */
  get byteLength(): number {
    const waits = this.#waitTicks.byteLength + this.#waitSums.byteLength;
    return waits + this.#commands.length * COMMAND_BYTES;
  }

  /** Command `index`, in the order of time. */
  at(index: number): TimelineCommand | undefined {
    return this.#commands[index];
  }

  /** How many commands began up to the end of `tick`: the index of the first one after it. */
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

  /** Ticks up to the end of `tick` in which a script had the robot and no command of it ran. */
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

  /** The command that runs is over; nothing where none runs. */
  recordEnd(tick: number, ending: EndingState): void {
    const index = this.#commands.length - 1;
    const last = this.#commands[index];
    if (last?.to !== null) return;
    this.#commands[index] = { ...last, to: tick, ending };
    this.#unchangedCommands = Math.min(this.#unchangedCommands, index);
  }

  /** From the end of `tick` on, the robot waits for a command, or does not. */
  setWaiting(tick: number, isWaiting: boolean): void {
    if (isWaiting === (this.#waitTicks.length % 2 === 1)) return;
    this.#waitSums.push(this.waitedUpTo(tick));
    this.#waitTicks.push(tick);
  }

  /** Forgets what came after the end of `tick`; a command that ended after it runs again. */
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

  /** What changed since the last call; null when nothing did. */
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

  /** Takes in what another log gained or lost. */
  applyDelta(delta: CommandDelta): void {
    this.#commands.length = Math.min(this.count, delta.unchangedCommands);
    for (const command of delta.commands) this.#commands.push(command);
    this.#waitTicks.replaceFrom(delta.unchangedWaits, delta.waitTicks);
    this.#waitSums.replaceFrom(delta.unchangedWaits, delta.waitSums);
  }
}
