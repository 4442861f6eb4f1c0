/** The runner's handle of a process of pages. */
import { fork, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { fileURLToPath } from "node:url";
import type { FromPages, ToPages } from "./page-messages.ts";

const entry = fileURLToPath(new URL("pages.process.ts", import.meta.url));

export class Pages {
  readonly #child: ChildProcess;

  private constructor(child: ChildProcess) {
    this.#child = child;
  }

  /** @param onMessage receives all messages of the pages */
  static async start(onMessage: (message: FromPages) => void): Promise<Pages> {
    const child = fork(entry, { stdio: ["ignore", "inherit", "inherit", "ipc"] });
    const ready = new Promise<void>((resolve, reject) => {
      child.once("exit", () => reject(new Error("The process of pages has ended.")));
      child.on("message", (message: FromPages) => {
        if (message.type === "ready") resolve();
        else onMessage(message);
      });
    });
    await ready;
    return new Pages(child);
  }

  send(message: ToPages): void {
    if (this.#child.connected) this.#child.send(message);
  }

  /** Kills the process immediately, whatever its pages are doing. */
  async kill(): Promise<void> {
    const child = this.#child;
    if (child.exitCode !== null || child.signalCode !== null) return;
    // All messages that its pages have sent are still received.
    const ended = Promise.all([once(child, "close"), once(child, "disconnect")]);
    child.kill("SIGKILL");
    await ended;
  }
}
