/** The real relay, started as `npm start` does, on a free port with its own data folder. */
import { spawn, type ChildProcessByStdio } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Readable } from "node:stream";
import { fileURLToPath } from "node:url";

const entry = fileURLToPath(new URL("../../apps/relay/src/main.ts", import.meta.url));
/** Holds compiled modules between starts: compiling takes half of a start's processor time. */
const compileCache = fileURLToPath(
  new URL("../../node_modules/.cache/compiled-modules", import.meta.url),
);
const READY = /^Corridor is ready: (\S+)$/m;
/** how many characters of its output are stored for debugging */
const MAX_LOG_LENGTH = 100_000;

type RelayChild = ChildProcessByStdio<null, Readable, Readable>;

export interface RelayOptions {
  /** environment variables besides PATH, NODE_COMPILE_CACHE, PORT and DATA_DIR */
  environment?: Record<string, string>;
  /** data folder, not removed on stop; default: a temporary folder removed on stop */
  folder?: string;
  /** arguments of the command line */
  arguments?: string[];
}

export class RelayProcess {
  readonly #environment: Record<string, string>;
  readonly #arguments: string[];
  readonly #folder: string;
  readonly #ownsFolder: boolean;
  #child: RelayChild;
  #closed: Promise<unknown>;
  #url = "";
  #log = "";

  private constructor(options: RelayOptions) {
    this.#environment = options.environment ?? {};
    this.#arguments = options.arguments ?? [];
    this.#ownsFolder = options.folder === undefined;
    this.#folder = options.folder ?? mkdtempSync(join(tmpdir(), "corridor-relay-"));
    [this.#child, this.#closed] = this.#spawn("0");
  }

  /** Starts a relay and waits until it is ready. */
  static async start(options: RelayOptions = {}): Promise<RelayProcess> {
    const relay = RelayProcess.launch(options);
    await relay.ready();
    return relay;
  }

  /** Starts a relay that may exit before it is ready. */
  static launch(options: RelayOptions = {}): RelayProcess {
    return new RelayProcess(options);
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
    return this.#child.pid ?? 0;
  }

  /** output of the current or the last process */
  get log(): string {
    return this.#log;
  }

  /** Waits until it is ready. @throws Error if the process exits before */
  async ready(): Promise<void> {
    const [, url = ""] = await this.says(READY);
    this.#url = url;
  }

  /** Waits until the output matches. @throws Error if the process exits before */
  async says(pattern: RegExp): Promise<RegExpExecArray> {
    for (;;) {
      const match = pattern.exec(this.#log);
      if (match !== null) return match;
      const { exitCode, signalCode, stdout, stderr } = this.#child;
      const end = exitCode ?? signalCode;
      if (end !== null) throw new Error(`The relay exited with ${end}: ${this.#log}`);
      await Promise.race([once(stdout, "data"), once(stderr, "data"), this.#closed]);
    }
  }

  /** Starts the relay on the same port with the same data, after `kill`. */
  async restart(): Promise<void> {
    this.#log = "";
    [this.#child, this.#closed] = this.#spawn(String(this.port));
    await this.ready();
  }

  signal(signal: NodeJS.Signals): void {
    this.#child.kill(signal);
  }

  /** Waits for the exit. @returns null after a signal */
  async exitCode(): Promise<number | null> {
    await this.#closed;
    return this.#child.exitCode;
  }

  /** Kills the relay without a shutdown, as a power cut does. */
  async kill(): Promise<void> {
    this.signal("SIGKILL");
    await this.#closed;
  }

  async killAndRestart(): Promise<void> {
    await this.kill();
    await this.restart();
  }

  async stop(): Promise<void> {
    this.signal("SIGTERM");
    await this.#closed;
    if (this.#ownsFolder) rmSync(this.#folder, { recursive: true, force: true, maxRetries: 5 });
  }

  #spawn(port: string): [child: RelayChild, closed: Promise<unknown>] {
    const child = spawn(process.execPath, [entry, ...this.#arguments], {
      env: {
        PATH: process.env["PATH"] ?? "",
        NODE_COMPILE_CACHE: compileCache,
        PORT: port,
        DATA_DIR: this.#folder,
        ...this.#environment,
      },
      stdio: ["ignore", "pipe", "pipe"],
    });
    for (const output of [child.stdout, child.stderr]) {
      output.on("data", (data: Buffer) => {
        this.#log = (this.#log + data.toString()).slice(-MAX_LOG_LENGTH);
      });
    }
    return [child, once(child, "close")];
  }
}
