/** Scripts in other languages as processes: the Python library and the Java example. */
import { spawn, type ChildProcess } from "node:child_process";
import { fileURLToPath } from "node:url";
import { inPath } from "../../../scripts/programs.ts";
import { exampleCommand } from "../../support/script.ts";

const library = fileURLToPath(new URL("../../../packages/client-python/src", import.meta.url));
/** sends a command, and another one after a line of input */
const PYTHON = `
import sys
from corridor import Robot
robot = Robot(sys.argv[1])
robot.left(5)
sys.stdin.readline()
robot.right(5)
`;

/** Whether a program is installed. */
export const hasProgram = (name: "python3" | "java"): boolean => inPath(name).length > 0;

export class ExampleScript {
  readonly #process: ChildProcess;
  /** output so far, for error messages */
  output = "";

  private constructor([command = "", ...args]: string[]) {
    this.#process = spawn(command, args, {
      stdio: ["pipe", "pipe", "pipe"],
      env: { ...process.env, PYTHONPATH: library },
    });
    for (const stream of [this.#process.stdout, this.#process.stderr]) {
      stream?.on("data", (data: Buffer) => (this.output += data.toString()));
    }
  }

  static python(address: string): ExampleScript {
    return new ExampleScript([inPath("python3")[0] ?? "python3", "-c", PYTHON, address]);
  }

  /** The Java example makes two moves along the wall to its right. */
  static java(address: string): ExampleScript {
    return new ExampleScript([...exampleCommand("Java"), address, "--moves", "2"]);
  }

  /** Makes the script send its next command. */
  sendNext(): void {
    this.#process.stdin?.write("\n");
  }

  kill(): void {
    this.#process.kill("SIGKILL");
  }
}
