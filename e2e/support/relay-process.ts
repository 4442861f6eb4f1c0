/** The real relay, started as `npm start` does, on a free port with a data folder of its own. */
import { spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";

const entry = fileURLToPath(new URL("../../apps/relay/src/main.ts", import.meta.url));

export class RelayProcess {
  readonly #process: ChildProcess;
  readonly #folder: string;
  /** the address that it printed, such as "http://localhost:41234" */
  readonly url: string;

  private constructor(process: ChildProcess, folder: string, url: string) {
    this.#process = process;
    this.#folder = folder;
    this.url = url;
  }

  /** Starts one and waits until it says that it is ready. */
  static async start(): Promise<RelayProcess> {
    const folder = mkdtempSync(join(tmpdir(), "corridor-e2e-"));
    const relay = spawn(process.execPath, [entry], {
      env: { ...process.env, PORT: "0", DATA_DIR: folder },
      stdio: ["ignore", "pipe", "inherit"],
    });
    for await (const line of createInterface({ input: relay.stdout })) {
      const url = /^Corridor is ready: (\S+)$/.exec(line)?.[1];
      if (url === undefined) continue;
      // What it goes on to say must not fill the pipe.
      relay.stdout.resume();
      return new RelayProcess(relay, folder, url);
    }
    throw new Error("The relay ended before it was ready; its own words stand above.");
  }

  async stop(): Promise<void> {
    const ended = once(this.#process, "exit");
    this.#process.kill();
    await ended;
    rmSync(this.#folder, { recursive: true, force: true, maxRetries: 5 });
  }
}
