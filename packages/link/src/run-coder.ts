/**
 * Codes a recorded run as bits, with one function for encoding and decoding: the starting maze and
 * program, the inputs in tick order, length, digest and name.
 *
 * A few characters can encode many edits, each of a large maze or a long program. Encoder and
 * decoder therefore limit the length of the document's JSON. A longer run is shared as a file.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Command, DriverName } from "@corridor/protocol";
import {
  MAX_RUN_INPUTS,
  MAX_RUN_NAME_LENGTH,
  type RunDocument,
  type RunInput,
  type TimedInput,
} from "@corridor/recording";
import type { Choices } from "./choices.ts";
import { CommandCoder, TickModel } from "./command-coder.ts";
import { MazeEditCoder, ProgramEditCoder } from "./edit-coder.ts";
import { codeMaze } from "./maze-coder.ts";
import { codeName } from "./name-coder.ts";
import { codeUniform, NumberModel, RealModel, SymbolModel } from "./numbers.ts";
import { codeProgram } from "./program-coder.ts";
import { BitModel, type BitCoder } from "./range-coder.ts";

/** Maximum length of the JSON, in characters: twenty edits of the longest program. */
const MAX_RUN_LINK_JSON = 256 * 1024;

const kinds = ["command", "driver", "cancel", "program", "maze"] as const;
const drivers = ["me", "program", "remote"] as const satisfies readonly DriverName[];

/**
 * Encodes or decodes a run.
 * @param run the run to encode; a decoder ignores it, and its caller passes any valid run
 * @param maxJson maximum length of the JSON; only tests set it
 * @returns the decoded run, not yet checked by its schema; null if it exceeds the bounds of a link,
 *   or if the bits cannot come from an encoder
 */
export function codeRun(
  coder: BitCoder,
  run: RunDocument,
  choices: Choices,
  maxJson = MAX_RUN_LINK_JSON,
): RunDocument | null {
  const maze = codeMaze(coder, run.maze, choices);
  if (maze === null) return null;
  const program = codeProgram(coder, run.program, choices.isPlainName(run.program.name));
  if (program === null) return null;
  const remaining = maxJson - lengthOf(maze) - lengthOf(program);
  const inputs = new InputCoder(maze, program, choices).codeAll(coder, run.inputs, remaining);
  if (inputs === null) return null;
  const last = inputs.at(-1)?.tick ?? 0;
  const ticks = last + new TickModel().code(coder, run.ticks - last);
  const digest = codeDigest(coder, run.digest);
  const isPlain = choices.isPlainName(run.name);
  const name = codeName(coder, run.name, MAX_RUN_NAME_LENGTH, isPlain);
  return {
    format: "corridor/run",
    version: 1,
    name,
    maze,
    program,
    seed: 0,
    ticks,
    inputs,
    digest,
  };
}

/** Codes the inputs of one run. Each input is predicted from the previous ones. */
class InputCoder {
  #maze: MazeDocument;
  #program: ProgramDocument;
  #seq = 0;
  readonly #ticks = new TickModel();
  readonly #kinds = new SymbolModel(3);
  readonly #drivers = new SymbolModel(2);
  readonly #commands = new CommandCoder();
  /** contexts: is it a script's command, is its number not the next one */
  readonly #seqBits = new BitModel(2, 4);
  readonly #seqs = new RealModel();
  readonly #mazes: MazeEditCoder;
  readonly #programs: ProgramEditCoder;

  constructor(maze: MazeDocument, program: ProgramDocument, choices: Choices) {
    this.#maze = maze;
    this.#program = program;
    this.#mazes = new MazeEditCoder(choices);
    this.#programs = new ProgramEditCoder(choices);
  }

  /** @param maxJson maximum length of the inputs' JSON, in characters */
  codeAll(coder: BitCoder, inputs: readonly TimedInput[], maxJson: number): TimedInput[] | null {
    const count = new NumberModel().code(coder, inputs.length);
    if (count > MAX_RUN_INPUTS) return null;
    const coded: TimedInput[] = [];
    let remaining = maxJson;
    let tick = 0;
    for (let at = 0; at < count; at += 1) {
      const input = inputs[at];
      tick += this.#ticks.code(coder, (input?.tick ?? 0) - tick);
      const read = this.#code(coder, input);
      if (read === null) return null;
      const timed: TimedInput = { tick, ...read };
      remaining -= lengthOf(timed);
      if (remaining < 0) return null;
      coded.push(timed);
    }
    return coded;
  }

  #code(coder: BitCoder, input: TimedInput | undefined): RunInput | null {
    const kind = kinds[this.#kinds.code(coder, kinds.indexOf(input?.do ?? "cancel"))];
    if (kind === undefined) return null;
    switch (kind) {
      case "command":
        return this.#codeCommand(coder, input?.do === kind ? input : undefined);
      case "driver": {
        const value = input?.do === kind ? input.driver : "me";
        const driver = drivers[this.#drivers.code(coder, drivers.indexOf(value))];
        return driver === undefined ? null : { do: kind, driver };
      }
      case "cancel":
        return { do: kind };
      case "program": {
        const after = input?.do === kind ? input.program : this.#program;
        const program = this.#programs.code(coder, this.#program, after);
        if (program === null) return null;
        this.#program = program;
        return { do: kind, program };
      }
      case "maze": {
        const after = input?.do === kind ? input.maze : this.#maze;
        const maze = this.#mazes.code(coder, this.#maze, after);
        if (maze === null) return null;
        this.#maze = maze;
        return { do: kind, maze };
      }
    }
  }

  #codeCommand(
    coder: BitCoder,
    input: { command: Command; seq?: number | undefined } | undefined,
  ): RunInput | null {
    const command = this.#commands.code(coder, input?.command ?? { action: "stop" });
    if (command === null) return null;
    const seq = input?.seq ?? 0;
    if (this.#seqBits.code(coder, 0, seq > 0 ? 1 : 0) === 0) return { do: "command", command };
    const isOther = this.#seqBits.code(coder, 1, seq === this.#seq + 1 ? 0 : 1) === 1;
    this.#seq = isOther ? this.#seqs.code(coder, seq) : this.#seq + 1;
    return { do: "command", command, seq: this.#seq };
  }
}

/** Length of the JSON, in characters. */
function lengthOf(value: MazeDocument | ProgramDocument | TimedInput): number {
  return JSON.stringify(value).length;
}

/** Codes 16 hexadecimal digits. */
function codeDigest(coder: BitCoder, digest: string): string {
  let coded = "";
  for (let at = 0; at < 16; at += 4) {
    const part = Number.parseInt(digest.slice(at, at + 4), 16);
    coded += codeUniform(coder, 65_536, part).toString(16).padStart(4, "0");
  }
  return coded;
}
