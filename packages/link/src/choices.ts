/** Choices of an encoder, such as the method for the blocks of a maze. A decoder reads them. */
import type { MazeDocument } from "@corridor/maze";
import type { BlockModels } from "./block-coder.ts";

export interface Choices {
  /**
   * Returns the index of the method for the blocks, 0 to `BLOCK_METHOD_COUNT` - 1.
   * @param models as before the maze; not changed
   */
  blockMethodOf: (maze: MazeDocument, models: BlockModels) => number;
  /** whether a name is coded as plain seven-bit characters */
  isPlainName: (name: string) => boolean;
}

/** What a decoder passes to the coding functions, which ignore it. */
export const noChoices: Choices = { blockMethodOf: () => 0, isPlainName: () => false };
