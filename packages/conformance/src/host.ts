/** HTTP requests to the host of a robot, as scripts send them. */
import {
  commandRecordSchema,
  hasEnded,
  featureListSchema,
  PROTOCOL_VERSION,
  readRobotAddress,
  snapshotSchema,
  type CommandRecord,
  type FeatureList,
  type Order,
  type RobotAddress,
  type Snapshot,
  type GatewayName,
} from "@corridor/protocol";
import { must, validate } from "./mismatch.ts";

const RESPONSE_MS = 40_000;
/** Timeout in ms for any command of the checks. */
const FINISH_MS = 60_000;
const START_MS = 10_000;
const MAX_RETRIES = 10;

export interface HttpResponse {
  status: number;
  header(name: string): string;
  text: string;
  /** undefined if the body is not valid JSON */
  json: unknown;
}

export interface RequestOptions {
  method?: string;
  /** null: no key is sent */
  key?: string | null;
  /** strings and bytes are sent unchanged, other values as JSON */
  body?: unknown;
  headers?: Record<string, string>;
}

/** Optional fields of `hello`. */
export interface HelloOptions {
  /** `STREAM-n` of the last state of an earlier connection */
  since?: string;
  /** ms by the clock of the script */
  sentAt?: number;
  key?: string;
  version?: number;
}

/** @returns the parts of a robot's address, or null if it is not one */
export function readAddress(text: string): RobotAddress | null {
  const parts = readRobotAddress(text.trim());
  return parts === null || parts.key === null ? null : { ...parts, key: parts.key };
}

export class Host {
  readonly origin: string;
  readonly id: string;
  readonly #key: string;
  #keys = 0;
  readonly #run = Math.trunc(performance.timeOrigin + performance.now()).toString(36);

  /** @throws Error if the address is not that of a robot */
  constructor(address: string) {
    const parts = readAddress(address);
    if (parts === null) {
      throw new Error(
        'This is not a robot\'s address. It looks like http://HOST/r/ID#KEY: put it in "quotes".',
      );
    }
    const { origin, id, key } = parts;
    this.origin = origin;
    this.id = id;
    this.#key = key;
  }

  get api(): string {
    return `${this.origin}/api/v1/robots/${this.id}`;
  }

  /** The URL of a gateway. ROS clients connect to it with WebSockets. */
  gatewayUrl(gateway: GatewayName): string {
    return gateway === "soap" ? `${this.origin}/soap` : `${this.origin}/r/${this.id}/${gateway}`;
  }

  /** The robot's address, as SOAP messages contain it. */
  addressWith(key = this.#key): string {
    return `${this.origin}/r/${this.id}#${key}`;
  }

  authorization(key = this.#key): { Authorization: string } {
    return { Authorization: `Bearer ${key}` };
  }

  /** The first message of a connection. */
  hello(terms: HelloOptions = {}) {
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
  async request(path: string, options: RequestOptions = {}): Promise<HttpResponse> {
    return this.requestUrl(this.api + path, options);
  }

  /** As `request`, for any URL of the host. */
  async requestUrl(url: string, options: RequestOptions = {}): Promise<HttpResponse> {
    for (let retryCount = 0; ; retryCount++) {
      const response = await this.#fetch(url, options);
      if (response.status !== 429 || retryCount === MAX_RETRIES) return response;
      await waitForRetryAfter(response);
    }
  }

  /** Sends one request, without retries. */
  async requestOnce(path: string, options: RequestOptions = {}): Promise<HttpResponse> {
    return this.#fetch(this.api + path, options);
  }

  /** Opens a stream that lasts until `signal` is aborted. */
  async open(path: string, signal: AbortSignal, headers: Record<string, string> = {}) {
    return fetch(this.api + path, { ...this.#initOf({ headers }), signal });
  }

  /**
   * The features that the host does not offer, with reasons. A response of 404 means that it offers
   * all.
   */
  async features(): Promise<FeatureList> {
    const response = await this.request("/features");
    if (response.status === 404) return { notOffered: [] };
    must(
      response.status === 200,
      "200 or 404 for GET /features",
      `${response.status} ${response.text}`,
    );
    return validate(featureListSchema, response.json, "a list of features");
  }

  /** Sends a command, which the host must accept. */
  async send(order: Order, key?: string): Promise<CommandRecord> {
    const headers = key === undefined ? {} : { "Idempotency-Key": key };
    const response = await this.request("/commands", { method: "POST", body: order, headers });
    must(response.status === 202, `202 for ${order.action}`, `${response.status} ${response.text}`);
    return validate(commandRecordSchema, response.json, "a command record");
  }

  async record(seq: number, wait = 0): Promise<CommandRecord> {
    const response = await this.request(`/commands/${seq}?wait=${wait}`);
    must(
      response.status === 200,
      `200 for the record ${seq}`,
      `${response.status} ${response.text}`,
    );
    return validate(commandRecordSchema, response.json, "a command record");
  }

  /** Waits until a command starts, so that later commands are queued. */
  async waitForStart(seq: number): Promise<void> {
    const deadline = performance.now() + START_MS;
    for (;;) {
      const { state } = await this.record(seq);
      if (state !== "accepted" && state !== "delivered") return;
      must(performance.now() < deadline, `command ${seq} to start`, state);
      await pause(50);
    }
  }

  async waitForEnd(seq: number): Promise<CommandRecord> {
    const deadline = performance.now() + FINISH_MS;
    for (;;) {
      const record = await this.record(seq, 10);
      if (hasEnded(record.state)) return record;
      must(
        performance.now() < deadline,
        `command ${seq} (${record.action}) to end within ${FINISH_MS / 1000} s`,
        `${record.state}: is the robot's page open, connected and not paused?`,
      );
    }
  }

  async sendAndWait(order: Order): Promise<CommandRecord> {
    return this.waitForEnd((await this.send(order)).seq);
  }

  async snapshot(query = "?wait=10"): Promise<Snapshot> {
    const response = await this.request(`/sensors${query}`);
    must(
      response.status === 200,
      `200 for /sensors${query}`,
      `${response.status} ${response.text}`,
    );
    return validate(snapshotSchema, response.json, "a snapshot");
  }

  /** The log entries after a number, page by page. */
  async log(after: number): Promise<unknown> {
    const response = await this.request(`/commands?after=${after}`);
    must(response.status === 200, "200 for the log", `${response.status} ${response.text}`);
    return response.json;
  }

  async #fetch(url: string, options: RequestOptions): Promise<HttpResponse> {
    const response = await fetch(url, {
      ...this.#initOf(options),
      signal: AbortSignal.timeout(RESPONSE_MS),
    });
    const text = await response.text();
    const header = (name: string): string => response.headers.get(name) ?? "";
    return { status: response.status, header, text, json: parse(text) };
  }

  #initOf({ method = "GET", key = this.#key, body, headers }: RequestOptions) {
    return {
      method,
      redirect: "manual" as const,
      headers: {
        ...(key !== null && this.authorization(key)),
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
export async function waitForRetryAfter(response: HttpResponse): Promise<void> {
  const seconds = Number(response.header("retry-after") || 1);
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
