/** The real relay, started as `npm start` does, on a free port with its own data folder. */
import { spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const entry = fileURLToPath(new URL("../../apps/relay/src/main.ts", import.meta.url));
const READY = /^Corridor is ready: (\S+)$/m;
/** how many characters of its output are stored for debugging */
const MAX_LOG_LENGTH = 100_000;

export interface RelayOptions {
  /** environment variables besides PORT and DATA_DIR */
  environment?: Record<string, string>;
  /** data folder, not removed on stop; default: a temporary folder removed on stop */
  folder?: string;
}

export class RelayProcess {
  readonly #environment: Record<string, string>;
  readonly #folder: string;
  readonly #ownsFolder: boolean;
  #child: ChildProcess | null = null;
  #url = "";
  #log = "";

  private constructor({ environment = {}, folder }: RelayOptions) {
    this.#environment = environment;
    this.#ownsFolder = folder === undefined;
    this.#folder = folder ?? mkdtempSync(join(tmpdir(), "corridor-e2e-"));
  }

  /** Starts a relay and waits until it is ready. */
  static async start(options: RelayOptions = {}): Promise<RelayProcess> {
    const relay = new RelayProcess(options);
    await relay.restart();
    return relay;
  }

  /** the address that the relay printed, such as "http://localhost:41234" */
  get url(): string {
    return this.#url;
  }

  get port(): number {
    return Number(new URL(this.#url).port);
  }

  /** of the current or the last process */
  get pid(): number {
    return this.#child?.pid ?? 0;
  }

  /** output of all its processes so far */
  get log(): string {
    return this.#log;
  }

  /** Starts the relay on the same port with the same data, after `kill`. */
  async restart(): Promise<void> {
    const port = this.#url === "" ? "0" : String(this.port);
    const child = spawn(process.execPath, [entry], {
      env: { ...process.env, PORT: port, DATA_DIR: this.#folder, ...this.#environment },
      stdio: ["ignore", "pipe", "pipe"],
    });
    this.#child = child;
    let text = "";
    await new Promise<void>((resolve, reject) => {
      child.stdout.on("data", (data: Buffer) => {
        const output = data.toString();
        this.#appendLog(output);
        text += output.slice(0, MAX_LOG_LENGTH - text.length);
        const url = READY.exec(text)?.[1];
        if (url === undefined) return;
        this.#url = url;
        resolve();
      });
      child.stderr.on("data", (data: Buffer) => {
        this.#appendLog(data.toString());
        process.stderr.write(data);
      });
      child.once("close", () => reject(new Error(`The relay ended before it was ready: ${text}`)));
    });
  }

  /** Kills the relay without a shutdown, as a power cut does. */
  async kill(): Promise<void> {
    await this.#end("SIGKILL");
  }

  async stop(): Promise<void> {
    await this.#end("SIGTERM");
    if (this.#ownsFolder) rmSync(this.#folder, { recursive: true, force: true, maxRetries: 5 });
  }

  async #end(signal: NodeJS.Signals): Promise<void> {
    const child = this.#child;
    if (child === null || child.exitCode !== null || child.signalCode !== null) return;
    const ended = once(child, "exit");
    child.kill(signal);
    await ended;
  }

  #appendLog(output: string): void {
    this.#log = (this.#log + output).slice(-MAX_LOG_LENGTH);
  }
}
