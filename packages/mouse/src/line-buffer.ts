/** Splits the output of a program into lines. */

/** Characters of a line. Longer lines are truncated: no command is as long. */
const MAX_LINE = 256;

export class LineBuffer {
  #rest = "";

  /** @returns the lines that are complete, without line ends */
  *add(text: string): Generator<string> {
    const parts = text.replaceAll("\r", "").split("\n");
    for (const [at, part] of parts.entries()) {
      this.#rest += part.slice(0, MAX_LINE - this.#rest.length);
      if (at === parts.length - 1) return;
      const line = this.#rest;
      this.#rest = "";
      yield line;
    }
  }
}
