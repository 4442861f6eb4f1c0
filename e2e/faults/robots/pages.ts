/** A process of pages, as the runner holds it. */
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

  /** @param heard is told of all that the pages tell */
  static async start(heard: (message: FromPages) => void): Promise<Pages> {
    const child = fork(entry, { stdio: ["ignore", "inherit", "inherit", "ipc"] });
    const ready = new Promise<void>((resolve, reject) => {
      child.once("exit", () => reject(new Error("The process of pages has ended.")));
      child.on("message", (message: FromPages) => {
        if (message.tells === "ready") resolve();
        else heard(message);
      });
    });
    await ready;
    return new Pages(child);
  }

  send(message: ToPages): void {
    if (this.#child.connected) this.#child.send(message);
  }

  /** Ends the process at once, in the midst of whatever its pages do. */
  async kill(): Promise<void> {
    const child = this.#child;
    if (child.exitCode !== null || child.signalCode !== null) return;
    // What its pages have told is heard to the end.
    const ended = Promise.all([once(child, "close"), once(child, "disconnect")]);
    child.kill("SIGKILL");
    await ended;
  }
}
