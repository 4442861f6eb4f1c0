/** A connection as a client library opens it: a WebSocket or a long-poll connection. */
import {
  fetchedMessagesSchema,
  openedConnectionSchema,
  relayToDriverSchema,
  takenMessagesSchema,
  type RelayToDriver,
} from "@corridor/protocol";
import type { HelloOptions, Host } from "./host.ts";
import { must, validate } from "./mismatch.ts";

const TIMEOUT_MS = 15_000;
/** wait of a long poll in seconds */
const WAIT = 1;
/** close code of a WebSocket that the host refused to open */
const NEVER_OPENED = 1006;
/** maximum size of a message or a request */
export const MAX_BYTES = 16 * 1024;
/** a message from a script; the first one is its hello */
type ScriptMessage = Readonly<Record<string, unknown>> & { type: string };

export abstract class Connection {
  /** all received messages, in order */
  readonly received: RelayToDriver[] = [];

  /**
   * Sends messages at once.
   * @param size minimum size of each message, or of its request, in bytes
   */
  abstract sendAll(messages: readonly ScriptMessage[], size?: number): Promise<void>;
  abstract close(): Promise<void>;
  /** Waits at most one second for a message. @throws Mismatch if the connection was closed */
  abstract wait(): Promise<void>;

  async send(message: ScriptMessage, size?: number): Promise<void> {
    await this.sendAll([message], size);
  }

  protected receive(message: unknown): void {
    this.received.push(validate(relayToDriverSchema, message, "a message to a script"));
  }

  /** Waits for a condition. @throws Mismatch after the timeout, or if the connection was closed */
  async until<T>(find: () => T | undefined, what: string, ms = TIMEOUT_MS): Promise<T> {
    const deadline = performance.now() + ms;
    for (;;) {
      const found = find();
      if (found !== undefined) return found;
      const types = [...new Set(this.received.map(({ type }) => type))].join(", ");
      must(
        performance.now() < deadline,
        what,
        `nothing of it within ${ms / 1_000} s, but ${types}`,
      );
      await this.wait();
    }
  }

  /** Waits for a message of a type. @param fits filter; default: any message */
  async message<T extends RelayToDriver["type"]>(
    type: T,
    fits: (message: Extract<RelayToDriver, { type: T }>) => boolean = () => true,
    ms?: number,
  ): Promise<Extract<RelayToDriver, { type: T }>> {
    const isOf = (each: RelayToDriver): each is Extract<RelayToDriver, { type: T }> =>
      each.type === type;
    return this.until(() => this.received.filter(isOf).find(fits), `a message ${type}`, ms);
  }
}

export type OpenConnection = (host: Host, terms?: HelloOptions) => Promise<Connection>;

class LongPollConnection extends Connection {
  readonly #host: Host;
  readonly #key: string;
  #sent = 0;

  constructor(host: Host, key: string) {
    super();
    this.#host = host;
    this.#key = key;
  }

  async sendAll(messages: readonly ScriptMessage[], size?: number): Promise<void> {
    const first = this.#sent + 1;
    this.#sent += messages.length;
    const body = textOf({ first, messages }, size);
    const response = await this.request("/messages", "POST", body);
    must(response.status === 200, "200 for posted messages", `${response.status} ${response.text}`);
    const { taken } = validate(
      takenMessagesSchema,
      response.json,
      "the number of accepted messages",
    );
    must(taken === this.#sent, `message ${this.#sent} accepted`, taken);
  }

  async close(): Promise<void> {
    await this.request("", "DELETE");
  }

  async wait(): Promise<void> {
    const response = await this.request(`/messages?after=${this.received.length}&wait=${WAIT}`);
    must(response.status === 200, "200 for messages", `${response.status} ${response.text}`);
    const fetched = validate(fetchedMessagesSchema, response.json, "fetched messages");
    must(fetched.closed === null, "an open connection", fetched.closed);
    const next = this.received.length + 1;
    must(fetched.first === next, `message ${next} as the first`, fetched.first);
    for (const message of fetched.messages) this.receive(message);
  }

  private async request(path: string, method = "GET", body?: string) {
    const options = { method, key: this.#key, ...(body !== undefined && { body }) };
    return this.#host.request(`/long-poll${path}`, options);
  }
}

class WebSocketConnection extends Connection {
  readonly #socket: WebSocket;
  readonly #texts: string[] = [];
  readonly #closed: Promise<number>;
  #code: number | null = null;
  #wake: () => void = () => undefined;

  constructor(socket: WebSocket, closed: Promise<number>) {
    super();
    this.#socket = socket;
    this.#closed = closed;
    socket.addEventListener("message", ({ data }) => {
      this.#texts.push(String(data));
      this.#wake();
    });
    void closed.then((code) => {
      this.#code = code;
      this.#wake();
    });
  }

  async sendAll(messages: readonly ScriptMessage[], size?: number): Promise<void> {
    for (const message of messages) this.#socket.send(textOf(message, size));
  }

  async close(): Promise<void> {
    this.#socket.close(1000);
    await this.#closed;
  }

  async wait(): Promise<void> {
    if (this.#texts.length === 0) {
      must(this.#code === null, "an open connection", `close code ${this.#code}`);
      await new Promise<void>((resolve) => {
        const timer = setTimeout(resolve, WAIT * 1_000);
        this.#wake = () => {
          clearTimeout(timer);
          resolve();
        };
      });
    }
    for (const text of this.#texts.splice(0)) this.receive(JSON.parse(text) as unknown);
  }
}

export const openByLongPoll: OpenConnection = async (host, terms) => {
  const response = await host.request("/long-poll", {
    method: "POST",
    key: null,
    body: host.hello(terms),
  });
  must(response.status === 201, "201 for a hello", `${response.status} ${response.text}`);
  const { key } = validate(openedConnectionSchema, response.json, "an opened connection");
  return new LongPollConnection(host, key);
};

export const openByWebSocket: OpenConnection = async (host, terms) => {
  const { socket, closed } = await openSocket(host);
  const connection = new WebSocketConnection(socket, closed);
  await connection.send(host.hello(terms));
  return connection;
};

/**
 * Sends messages on a new WebSocket.
 * @returns the host's close code; null if the socket stays open
 */
export async function closeCodeAfter(host: Host, ...texts: string[]): Promise<number | null> {
  const { socket, closed } = await openSocket(host);
  for (const text of texts) socket.send(text);
  const deadline = new Promise<null>((resolve) => setTimeout(resolve, TIMEOUT_MS, null));
  const code = await Promise.race([closed, deadline]);
  socket.close();
  return code;
}

async function openSocket(host: Host) {
  const { socket, opened, closed } = connectSocket(`${host.api}/socket`);
  const code = await Promise.race([opened, closed]);
  must(code === null, "a WebSocket", `close code ${code} instead of its opening`);
  return { socket, closed };
}

/**
 * Starts a WebSocket.
 * @returns also when it opens, and its close code: 1006 if the host refuses the upgrade
 */
export function connectSocket(url: string, headers: Record<string, string> = {}) {
  const socket = new WebSocket(url.replace(/^http/, "ws"), { headers });
  const closed = new Promise<number>((resolve) => {
    socket.addEventListener("close", ({ code }) => resolve(code));
    // Node.js 20 sends no close event after a refused upgrade.
    socket.addEventListener("error", () => resolve(NEVER_OPENED));
  });
  const opened = new Promise<null>((resolve) =>
    socket.addEventListener("open", () => resolve(null)),
  );
  return { socket, opened, closed };
}

/** JSON, padded with spaces to a size in bytes. */
export function textOf(value: object, size = 0): string {
  const text = JSON.stringify(value);
  return text + " ".repeat(Math.max(0, size - Buffer.byteLength(text)));
}
