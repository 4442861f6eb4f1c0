/**
 * A micromouse program as a process. Neither a program that floods its output nor one that never reads
 * its input uses unbounded memory: each waits for the other.
 */
import { spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import type { Readable, Writable } from "node:stream";
import { BridgeError } from "../bridge-error.ts";
import type { ProgramCall } from "./split-program.ts";

/** Time to end by itself after a signal. */
const KILL_MS = 500;

export class MouseProgram {
  readonly #file: string;
  readonly #child: ChildProcess;
  readonly #input: Writable;
  readonly #output: Readable;
  /** resolves when it has ended, with a sentence if it failed */
  readonly ended: Promise<string | null>;

  /** @throws BridgeError if it cannot be started */
  static async start({ file, args }: ProgramCall): Promise<MouseProgram> {
    const child = spawn(file, args, { stdio: ["pipe", "pipe", "inherit"] });
    try {
      await once(child, "spawn");
    } catch (error) {
      throw new BridgeError(startFailure(file, error), { cause: error });
    }
    return new MouseProgram(file, child);
  }

  private constructor(file: string, child: ChildProcess) {
    const { stdin, stdout } = child;
    if (stdin === null || stdout === null) throw new TypeError("no pipes");
    this.#file = file;
    this.#child = child;
    this.#input = stdin;
    this.#output = stdout;
    // It has closed its input, or has ended.
    stdin.on("error", () => undefined);
    stdout.on("error", () => undefined);
    this.ended = once(child, "exit").then(([code, signal]: (number | string | null)[]) => {
      if (code === 0) return null;
      return `The program ${this.#file} ended with ${signal ?? `exit code ${code}`}.`;
    });
  }

  /** Reads what it writes, until the end of its output. */
  async read(receive: (text: string) => Promise<void>): Promise<void> {
    for await (const text of this.#output.setEncoding("utf8")) {
      await receive(String(text));
      if (process.stderr.writableNeedDrain) await once(process.stderr, "drain");
    }
  }

  /** Writes a line. @returns resolves when it accepts more */
  async write(line: string): Promise<void> {
    if (!this.#input.writable || this.#input.write(`${line}\n`)) return;
    await Promise.race([once(this.#input, "drain"), once(this.#input, "close")]);
  }

  async stop(): Promise<void> {
    this.#child.kill();
    const timer = setTimeout(() => void this.#child.kill("SIGKILL"), KILL_MS);
    await this.ended;
    clearTimeout(timer);
    // A process that it has started may hold them open.
    this.#input.destroy();
    this.#output.destroy();
  }
}

function startFailure(file: string, error: unknown): string {
  const { code = "" } = error as NodeJS.ErrnoException;
  if (code === "ENOENT") {
    return `There is no program ${file}. A program in this folder starts with ./`;
  }
  if (code === "EACCES") {
    return `${file} cannot be executed. Write its language first, such as python3 ${file}`;
  }
  return `The program ${file} cannot be started (${code}).`;
}
