/** Codes commands and ticks, of recorded runs and of drives. */
import { plainActions, type Command } from "@corridor/protocol";
import { NumberModel, RealModel, SymbolModel } from "./numbers.ts";
import { BitModel, type BitCoder } from "./range-coder.ts";

/** In symbol order. */
const actions: readonly Command["action"][] = [...plainActions, "move", "turn", "drive"];

/** Value that a decoder passes and ignores. */
const placeholderDrive: { left: number; right: number; milliseconds?: number | undefined } = {
  left: 0,
  right: 0,
};

/** Codes commands with adaptive models of their actions and amounts. */
export class CommandCoder {
  readonly #actions = new SymbolModel(4);
  readonly #amounts = new RealModel();
  readonly #bits = new BitModel(1, 4);

  code(coder: BitCoder, command: Command): Command | null {
    const action = actions[this.#actions.code(coder, actions.indexOf(command.action))];
    const amount = (value: number): number => this.#amounts.code(coder, value);
    if (action === undefined) return null;
    if (action === "move") {
      return { action, distance: amount(command.action === action ? command.distance : 0) };
    }
    if (action === "turn") {
      return { action, degrees: amount(command.action === action ? command.degrees : 0) };
    }
    if (action === "drive") {
      return this.#codeDrive(coder, command.action === action ? command : placeholderDrive);
    }
    return { action };
  }

  #codeDrive(coder: BitCoder, drive: typeof placeholderDrive): Command {
    const amount = (value: number): number => this.#amounts.code(coder, value);
    const left = amount(drive.left);
    const right = amount(drive.right);
    const { milliseconds } = drive;
    const isTimed = this.#bits.code(coder, 0, milliseconds === undefined ? 0 : 1) === 1;
    return isTimed
      ? { action: "drive", left, right, milliseconds: amount(milliseconds ?? 0) }
      : { action: "drive", left, right };
  }
}

/** Codes whole numbers of ticks from 0 to a day: the upper and the lower 16 bits separately. */
export class TickModel {
  readonly #high = new NumberModel();
  readonly #low = new NumberModel();

  code(coder: BitCoder, ticks: number): number {
    const high = this.#high.code(coder, ticks >>> 16);
    return high * 65_536 + this.#low.code(coder, ticks & 65_535);
  }
}
