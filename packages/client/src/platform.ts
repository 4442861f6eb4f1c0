/**
 * Platform APIs that the client uses: WebSocket, HTTP, time and randomness. Browsers, workers and
 * Node provide them; tests replace them.
 */
import type { SocketEvents, SocketFactory, SocketPort } from "@corridor/protocol";

export interface Clock {
  /** ms by a monotonic clock */
  now(): number;
  /** Calls once after `ms`. @returns a function that cancels the call */
  after(ms: number, call: () => void): () => void;
}

/** The part of `fetch` that `registerRobot` uses. */
export type Fetch = (
  url: string,
  request: { method: string },
) => Promise<{ status: number; text(): Promise<string> }>;

export interface HttpRequest {
  method: string;
  url: string;
  /** bearer key; null: none */
  key: string | null;
  /** JSON; null: no body */
  body: string | null;
}

export interface HttpResponse {
  status: number;
  body: string;
  etag?: string | null;
  /** the header `Retry-After` */
  retryAfter?: string | null;
}

/** Sends a request. `response` rejects if there is none, or after `cancel`. */
export type SendRequest = (request: HttpRequest) => {
  response: Promise<HttpResponse>;
  cancel(): void;
};

/** The APIs of the current platform; tests may replace each. */
export interface Platform {
  connect: SocketFactory;
  /** for long polling, pairing and mazes; without it, there is no fallback for WebSockets */
  request?: SendRequest;
  clock: Clock;
  /** from 0 to below 1, for the delays between attempts */
  random(): number;
  /** a random unique text, for idempotency keys */
  uniqueText(): string;
  /** prints why a script waits; without it, nothing is printed */
  warn?(text: string): void;
}

interface GlobalWebSocket {
  onopen: (() => void) | null;
  onmessage: ((event: { data: unknown }) => void) | null;
  onclose: ((event: { code: number }) => void) | null;
  readonly readyState: number;
  readonly bufferedAmount: number;
  send(text: string): void;
  close(code: number, reason: string): void;
}

/** An extension of Node: the second parameter may contain headers. */
interface SocketOptions {
  headers: Record<string, string>;
}

interface GlobalRequest {
  method: string;
  headers: Record<string, string>;
  body: string | null;
  signal: unknown;
  cache: "no-store";
  credentials: "omit";
}

interface GlobalResponse {
  status: number;
  headers: { get(name: string): string | null };
  text(): Promise<string>;
}

interface Globals {
  fetch(url: string, request: GlobalRequest): Promise<GlobalResponse>;
  AbortController: new () => { signal: unknown; abort(): void };
  /** absent in Node 20 */
  WebSocket?: new (url: string, options?: SocketOptions) => GlobalWebSocket;
  performance: { now(): number };
  setTimeout(call: () => void, ms: number): unknown;
  clearTimeout(timer: unknown): void;
  console: { warn(text: string): void };
  crypto: { getRandomValues(into: Uint32Array): Uint32Array };
}

const OPEN = 1;
/** close code of a WebSocket that was never open */
const FAILED = 1006;

/**
 * The platform of browsers, workers and Node 20 and later. Without WebSocket, long polling works.
 * @param userAgent header `User-Agent`, in Node only; default: that of Node
 */
export function globalPlatform(userAgent?: string): Platform {
  const agent: Record<string, string> = userAgent === undefined ? {} : { "User-Agent": userAgent };
  const globals = globalThis as unknown as Globals;
  const randomWord = (): number => globals.crypto.getRandomValues(new Uint32Array(1))[0] ?? 0;
  return {
    connect: (url, events) => {
      const { WebSocket } = globals;
      if (WebSocket === undefined) return noSocket(events);
      const socket =
        userAgent === undefined ? new WebSocket(url) : new WebSocket(url, { headers: agent });
      return openSocket(socket, events);
    },
    request: ({ method, url, key, body }) => {
      const controller = new globals.AbortController();
      const headers = {
        ...agent,
        ...(key !== null && { Authorization: `Bearer ${key}` }),
        ...(body !== null && { "Content-Type": "application/json" }),
      };
      const { signal } = controller;
      const init = {
        method,
        headers,
        body,
        signal,
        cache: "no-store",
        credentials: "omit",
      } as const;
      const response = globals.fetch(url, init).then(async (answered) => ({
        status: answered.status,
        etag: answered.headers.get("ETag"),
        retryAfter: answered.headers.get("Retry-After"),
        body: await answered.text(),
      }));
      return { response, cancel: () => controller.abort() };
    },
    clock: {
      now: () => globals.performance.now(),
      after: (ms, call) => {
        const timer = globals.setTimeout(call, ms);
        return () => globals.clearTimeout(timer);
      },
    },
    warn: (text) => globals.console.warn(text),
    random: () => randomWord() / 4_294_967_296,
    uniqueText: () =>
      Array.from({ length: 4 }, () => randomWord().toString(36).padStart(7, "0")).join(""),
  };
}

/** A socket that fails, as if the network blocked it: the connection falls back. */
function noSocket(events: SocketEvents): SocketPort {
  void Promise.resolve().then(() => events.closed(FAILED));
  return { send: () => undefined, close: () => undefined, isOpen: false, waitingBytes: 0 };
}

function openSocket(socket: GlobalWebSocket, events: SocketEvents) {
  socket.onopen = () => events.opened();
  socket.onmessage = ({ data }) => {
    if (typeof data === "string") events.received(data);
  };
  socket.onclose = ({ code }) => events.closed(code);
  return {
    send: (text: string) => {
      if (socket.readyState === OPEN) socket.send(text);
    },
    close: (code: number, reason: string) => socket.close(code, reason),
    get isOpen() {
      return socket.readyState === OPEN;
    },
    get waitingBytes() {
      return socket.bufferedAmount;
    },
  };
}
