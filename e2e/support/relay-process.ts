/** The real relay, started as `npm start` does, on a free port with a data folder of its own. */
import { spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const entry = fileURLToPath(new URL("../../apps/relay/src/main.ts", import.meta.url));
const READY = /^Corridor is ready: (\S+)$/m;
/** Of what it says so much is kept, for who looks for a fault. */
const KEPT_CHARACTERS = 100_000;

export interface RelayOptions {
  /** settings besides PORT and DATA_DIR */
  environment?: Record<string, string>;
  /** for its data, and left as it is; default: one that goes with the relay */
  folder?: string;
}

export class RelayProcess {
  readonly #environment: Record<string, string>;
  readonly #folder: string;
  readonly #isFolderOwn: boolean;
  #child: ChildProcess | null = null;
  #url = "";
  #log = "";

  private constructor({ environment = {}, folder }: RelayOptions) {
    this.#environment = environment;
    this.#isFolderOwn = folder === undefined;
    this.#folder = folder ?? mkdtempSync(join(tmpdir(), "corridor-e2e-"));
  }

  /** Starts one and waits until it says that it is ready. */
  static async start(options: RelayOptions = {}): Promise<RelayProcess> {
    const relay = new RelayProcess(options);
    await relay.startAgain();
    return relay;
  }

  /** the address that it printed, such as "http://localhost:41234" */
  get url(): string {
    return this.#url;
  }

  get port(): number {
    return Number(new URL(this.#url).port);
  }

  /** of the process that runs now, or ran last */
  get pid(): number {
    return this.#child?.pid ?? 0;
  }

  /** what its processes have said so far */
  get log(): string {
    return this.#log;
  }

  /** Starts it on the same port with the same data, after `kill`. */
  async startAgain(): Promise<void> {
    const port = this.#url === "" ? "0" : String(this.port);
    const child = spawn(process.execPath, [entry], {
      env: { ...process.env, PORT: port, DATA_DIR: this.#folder, ...this.#environment },
      stdio: ["ignore", "pipe", "pipe"],
    });
    this.#child = child;
    let text = "";
    await new Promise<void>((resolve, reject) => {
      child.stdout.on("data", (data: Buffer) => {
        const said = data.toString();
        this.#keep(said);
        text += said.slice(0, KEPT_CHARACTERS - text.length);
        const url = READY.exec(text)?.[1];
        if (url === undefined) return;
        this.#url = url;
        resolve();
      });
      child.stderr.on("data", (data: Buffer) => {
        this.#keep(data.toString());
        process.stderr.write(data);
      });
      child.once("close", () => reject(new Error(`The relay ended before it was ready: ${text}`)));
    });
  }

  /** Ends it as a power cut would. */
  async kill(): Promise<void> {
    await this.#end("SIGKILL");
  }

  async stop(): Promise<void> {
    await this.#end("SIGTERM");
    if (this.#isFolderOwn) rmSync(this.#folder, { recursive: true, force: true, maxRetries: 5 });
  }

  async #end(signal: NodeJS.Signals): Promise<void> {
    const child = this.#child;
    if (child === null || child.exitCode !== null || child.signalCode !== null) return;
    const ended = once(child, "exit");
    child.kill(signal);
    await ended;
  }

  #keep(said: string): void {
    this.#log = (this.#log + said).slice(-KEPT_CHARACTERS);
  }
}
