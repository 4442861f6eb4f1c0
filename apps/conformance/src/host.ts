/** HTTP requests to the host of a robot, as scripts send them. */
import {
  commandRecordSchema,
  hasEnded,
  featureListSchema,
  PROTOCOL_VERSION,
  snapshotSchema,
  type CommandRecord,
  type FeatureList,
  type Order,
  type Snapshot,
} from "@corridor/protocol";
import { must, shaped } from "./mismatch.ts";

const ADDRESS = /^(https?:\/\/[^/?#\s@]+)\/r\/([A-Za-z0-9_-]{1,64})#([A-Za-z0-9_-]{8,64})$/;
const ANSWER_MS = 40_000;
/** Timeout in ms for any command of the checks. */
const FINISH_MS = 60_000;
const START_MS = 10_000;
const MOST_PAUSES = 10;

export interface Answer {
  status: number;
  header(name: string): string;
  text: string;
  /** undefined if the body is not valid JSON */
  json: unknown;
}

export interface AskOptions {
  method?: string;
  /** null: no key is sent */
  key?: string | null;
  /** strings and bytes are sent unchanged, other values as JSON */
  body?: unknown;
  headers?: Record<string, string>;
}

/** Optional fields of `hello`. */
export interface HelloTerms {
  /** `STREAM-n` of the last state of an earlier connection */
  since?: string;
  /** ms by the clock of the script */
  sentAt?: number;
  key?: string;
  version?: number;
}

export class Host {
  readonly origin: string;
  readonly id: string;
  readonly #key: string;
  #keys = 0;
  readonly #run = Math.trunc(performance.timeOrigin + performance.now()).toString(36);

  /** @throws Error if the address is not that of a robot */
  constructor(address: string) {
    const [, origin, id, key] = ADDRESS.exec(address.trim()) ?? [];
    if (origin === undefined || id === undefined || key === undefined) {
      throw new Error(
        'This is not a robot\'s address. It looks like http://HOST/r/ID#KEY: put it in "quotes".',
      );
    }
    this.origin = origin;
    this.id = id;
    this.#key = key;
  }

  get api(): string {
    return `${this.origin}/api/v1/robots/${this.id}`;
  }

  /** The first message of a connection. */
  hello(terms: HelloTerms = {}) {
    const hello = { type: "hello", version: PROTOCOL_VERSION, role: "drive", key: this.#key };
    return { ...hello, ...terms };
  }

  /** An idempotency key that this run has not used before. */
  newKey(): string {
    this.#keys += 1;
    return `check-${this.#run}-${this.#keys}`;
  }

  /** A well-formed key that does not belong to the robot. */
  get wrongKey(): string {
    const last = this.#key.endsWith("A") ? "B" : "A";
    return this.#key.slice(0, -1) + last;
  }

  /** Sends a request to the robot's API. Retries a response of 429 after `Retry-After`. */
  async ask(path: string, options: AskOptions = {}): Promise<Answer> {
    for (let pauses = 0; ; pauses++) {
      const answer = await this.askOnce(path, options);
      if (answer.status !== 429 || pauses === MOST_PAUSES) return answer;
      await pauseForRetryAfter(answer);
    }
  }

  /** Sends one request, without retries. */
  async askOnce(path: string, options: AskOptions = {}): Promise<Answer> {
    const response = await fetch(this.api + path, {
      ...this.#request(options),
      signal: AbortSignal.timeout(ANSWER_MS),
    });
    const text = await response.text();
    const header = (name: string): string => response.headers.get(name) ?? "";
    return { status: response.status, header, text, json: parse(text) };
  }

  /** Opens a stream that lasts until `signal` is aborted. */
  async open(path: string, signal: AbortSignal, headers: Record<string, string> = {}) {
    return fetch(this.api + path, { ...this.#request({ headers }), signal });
  }

  /**
   * The features that the host does not offer, with reasons. A response of 404 means that it offers
   * all.
   */
  async features(): Promise<FeatureList> {
    const answer = await this.ask("/features");
    if (answer.status === 404) return { notOffered: [] };
    must(answer.status === 200, "200 or 404 for GET /features", `${answer.status} ${answer.text}`);
    return shaped(featureListSchema, answer.json, "a list of features");
  }

  /** Sends a command, which the host must accept. */
  async send(order: Order, key?: string): Promise<CommandRecord> {
    const headers = key === undefined ? {} : { "Idempotency-Key": key };
    const answer = await this.ask("/commands", { method: "POST", body: order, headers });
    must(answer.status === 202, `202 for ${order.action}`, `${answer.status} ${answer.text}`);
    return shaped(commandRecordSchema, answer.json, "a command record");
  }

  async record(seq: number, wait = 0): Promise<CommandRecord> {
    const answer = await this.ask(`/commands/${seq}?wait=${wait}`);
    must(answer.status === 200, `200 for the record ${seq}`, `${answer.status} ${answer.text}`);
    return shaped(commandRecordSchema, answer.json, "a command record");
  }

  /** Waits until a command starts, so that later commands are queued. */
  async begun(seq: number): Promise<void> {
    const giveUp = performance.now() + START_MS;
    for (;;) {
      const { state } = await this.record(seq);
      if (state !== "accepted" && state !== "delivered") return;
      must(performance.now() < giveUp, `command ${seq} to start`, state);
      await pause(50);
    }
  }

  async ended(seq: number): Promise<CommandRecord> {
    const giveUp = performance.now() + FINISH_MS;
    for (;;) {
      const record = await this.record(seq, 10);
      if (hasEnded(record.state)) return record;
      must(
        performance.now() < giveUp,
        `command ${seq} (${record.action}) to end within ${FINISH_MS / 1000} s`,
        `${record.state}: is the robot's page open, connected and not paused?`,
      );
    }
  }

  async done(order: Order): Promise<CommandRecord> {
    return this.ended((await this.send(order)).seq);
  }

  async snapshot(query = "?wait=10"): Promise<Snapshot> {
    const answer = await this.ask(`/sensors${query}`);
    must(answer.status === 200, `200 for /sensors${query}`, `${answer.status} ${answer.text}`);
    return shaped(snapshotSchema, answer.json, "a snapshot");
  }

  /** The log entries after a number, page by page. */
  async log(after: number): Promise<unknown> {
    const answer = await this.ask(`/commands?after=${after}`);
    must(answer.status === 200, "200 for the log", `${answer.status} ${answer.text}`);
    return answer.json;
  }

  #request({ method = "GET", key = this.#key, body, headers }: AskOptions) {
    return {
      method,
      redirect: "manual" as const,
      headers: {
        ...(key !== null && { Authorization: `Bearer ${key}` }),
        ...(body !== undefined && { "Content-Type": "application/json" }),
        ...headers,
      },
      ...(body !== undefined && { body: isRaw(body) ? body : JSON.stringify(body) }),
    };
  }
}

export async function pause(milliseconds: number): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve, milliseconds));
}

/** Waits for the seconds of `Retry-After`. */
export async function pauseForRetryAfter(answer: Answer): Promise<void> {
  const seconds = Number(answer.header("retry-after") || 1);
  await pause(Math.min(10, Number.isFinite(seconds) ? seconds : 1) * 1000);
}

function isRaw(body: unknown): body is string | Uint8Array<ArrayBuffer> {
  return typeof body === "string" || body instanceof Uint8Array;
}

function parse(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}
