import {
  closeReasons,
  fetchedMessagesSchema,
  LONG_POLL_SECONDS,
  MAX_FRAME_BYTES,
  MAX_LONG_POLL_MESSAGES,
  openedConnectionSchema,
  readJson,
  takenMessagesSchema,
  type SocketEvents,
  type SocketPort,
  isTemporary,
} from "@corridor/protocol";
import type { HttpResponse, SendRequest, Platform } from "./platform.ts";
import { FIRST_DELAY_MS, Backoff } from "./backoff.ts";
import { retryDelay } from "./retry-delay.ts";

/** Shortest wait of a long poll, in seconds. */
const MIN_WAIT = 1;
/** Request timeout, in addition to the wait. */
const RESPONSE_MS = 8_000;
/** Interval between posts: messages of that time are sent together. */
const POST_INTERVAL_MS = 50;
/** The relay closes a connection that is silent for 15 s. */
const GIVE_UP_MS = 12_000;
/** Leaves space for the number and the brackets. */
const MAX_BATCH = MAX_FRAME_BYTES - 64;
const MAX_RESPONSE = 1024 * 1024;

/** Close code of a lost connection. */
const LOST = 1006;

/**
 * A message, or a function that creates it when it is sent. A message that contains its own age is
 * created again for each attempt.
 */
export type OutgoingMessage = string | (() => string);

export function textOf(message: OutgoingMessage): string {
  return typeof message === "string" ? message : message();
}

/** The failures of one of the two kinds of requests, posts and fetches. */
interface Retries {
  readonly backoff: Backoff;
  /** whether the last request got no response */
  isLost: boolean;
  /** shortens the current delay */
  hurry(): void;
}

type LongPollPlatform = Pick<Platform, "clock" | "random"> & { request: SendRequest };

/**
 * A socket that posts outgoing messages and fetches incoming ones by long poll. Messages are
 * numbered, so that failed requests can be repeated without duplicating messages.
 */
export class LongPollConnection implements SocketPort {
  readonly #url: string;
  readonly #platform: LongPollPlatform;
  readonly #events: SocketEvents;
  #key: string | null = null;
  /** unacknowledged messages, oldest first, and the number of the first */
  #queue: OutgoingMessage[] = [];
  #first = 1;
  #isPosting = false;
  #isOpen = true;
  /** number of the newest received message */
  #after = 0;
  #wait = LONG_POLL_SECONDS;
  readonly #posts = noFailure();
  readonly #fetches = noFailure();
  readonly #cancels = new Set<() => void>();

  /**
   * Opens a connection. Calls no callback before the constructor has returned.
   * @param url of a robot or a class, such as `https://HOST/api/v1/robots/ID/long-poll`
   */
  constructor(url: string, platform: LongPollPlatform, events: SocketEvents) {
    this.#url = url;
    this.#platform = platform;
    this.#events = events;
    this.#later(0, () => events.opened());
  }

  get isOpen(): boolean {
    return this.#isOpen;
  }

  get waitingBytes(): number {
    return this.#queue.reduce((sum, message) => sum + textOf(message).length, 0);
  }

  /** Sends one message. The first message, `hello`, opens the connection. */
  send(message: OutgoingMessage): void {
    if (!this.#isOpen) return;
    if (this.#key === null && !this.#isPosting) {
      this.#isPosting = true;
      void this.#hello(textOf(message));
      return;
    }
    this.#queue.push(message);
    void this.#post();
  }

  close(): void {
    if (this.#isOpen && this.#key !== null)
      this.#request("DELETE", "", null, RESPONSE_MS).catch(() => null);
    this.#end();
  }

  /** Repeats failed requests soon: the network may be back. */
  hurry(): void {
    for (const retries of [this.#posts, this.#fetches]) {
      if (!retries.isLost) continue;
      retries.backoff.reset();
      retries.hurry();
    }
  }

  async #hello(text: string): Promise<void> {
    try {
      const { status, body } = await this.#request("POST", "", text, RESPONSE_MS);
      if (!this.#isOpen) return;
      const opened = readJson(openedConnectionSchema, body, MAX_RESPONSE);
      if (status !== 201 || !opened.ok) return this.#lost(codeOf(status, body));
      this.#key = opened.value.key;
    } catch {
      return this.#lost(LOST);
    }
    this.#isPosting = false;
    void this.#fetch();
    void this.#post();
  }

  /** Posts until the queue is empty. */
  async #post(): Promise<void> {
    if (this.#isPosting || this.#key === null) return;
    this.#isPosting = true;
    while (this.#isOpen && this.#queue.length > 0) {
      const response = await this.#withRetries(this.#posts, () => {
        const body = `{"first":${this.#first},"messages":[${this.#batch().join()}]}`;
        return this.#request("POST", "/messages", body, RESPONSE_MS);
      });
      if (response === null || !this.#isOpen) return;
      const received = readJson(takenMessagesSchema, response.body, MAX_RESPONSE);
      if (!received.ok) return this.#lost(LOST);
      const count = received.value.taken - this.#first + 1;
      // Only a relay that does not know this connection acknowledges no message, or too many.
      if (count <= 0 || count > this.#queue.length) return this.#lost(LOST);
      this.#queue.splice(0, count);
      this.#first += count;
      await this.#delay(POST_INTERVAL_MS);
    }
    this.#isPosting = false;
  }

  #batch(): string[] {
    let characters = 0;
    const texts = this.#queue.slice(0, MAX_LONG_POLL_MESSAGES).map(textOf);
    const fitting = texts.findIndex((text) => (characters += text.length + 1) > MAX_BATCH);
    return fitting < 0 ? texts : texts.slice(0, Math.max(1, fitting));
  }

  /** Fetches messages until the connection is closed. */
  async #fetch(): Promise<void> {
    while (this.#isOpen) {
      const response = await this.#withRetries(this.#fetches, () => this.#fetchOnce());
      if (response === null || !this.#isOpen) return;
      const fetched = readJson(fetchedMessagesSchema, response.body, MAX_RESPONSE);
      if (!fetched.ok) return this.#lost(LOST);
      const { first, messages, closed } = fetched.value;
      for (const [index, message] of messages.entries()) {
        if (first + index <= this.#after || !this.#isOpen) continue;
        this.#after = first + index;
        this.#events.received(JSON.stringify(message));
      }
      if (closed !== null) return this.#lost(closed.code);
    }
  }

  async #fetchOnce(): Promise<HttpResponse> {
    const start = this.#platform.clock.now();
    const query = `/messages?after=${this.#after}&wait=${this.#wait}`;
    try {
      return await this.#request("GET", query, null, this.#wait * 1_000 + RESPONSE_MS);
    } catch (error) {
      // A proxy may close requests that wait too long: the next one waits less.
      const seconds = (this.#platform.clock.now() - start) / 1_000;
      if (seconds > MIN_WAIT) {
        this.#wait = Math.max(MIN_WAIT, Math.floor(Math.min(seconds, this.#wait) * 0.7));
      }
      throw error;
    }
  }

  /** Repeats a request while it fails temporarily. @returns null if the connection is lost */
  async #withRetries(
    retries: Retries,
    request: () => Promise<HttpResponse>,
  ): Promise<HttpResponse | null> {
    let failedSince: number | null = null;
    while (this.#isOpen) {
      const start = this.#platform.clock.now();
      const response = await request().catch(() => null);
      if (!this.#isOpen) return null;
      if (response?.status === 200) {
        retries.isLost = false;
        retries.backoff.reset();
        // The network is back: the other kind of request need not wait any longer.
        this.hurry();
        return response;
      }
      const isFinal = response !== null && !isTemporary(response);
      const now = this.#platform.clock.now();
      failedSince ??= response === null ? start : now;
      // The failure of a long wait does not prove that the connection is lost; the next request
      // will.
      if (now - start > GIVE_UP_MS / 2) {
        failedSince = now;
        retries.backoff.reset();
      }
      if (isFinal || now - failedSince > GIVE_UP_MS) {
        this.#lost(LOST);
        return null;
      }
      retries.isLost = response === null;
      const delayMs = retries.backoff.next(now, this.#platform.random());
      await this.#delayRetry(retries, retryDelay(response, delayMs));
    }
    return null;
  }

  #delayRetry(retries: Retries, ms: number): Promise<void> {
    const { clock, random } = this.#platform;
    const end = clock.now() + ms;
    return new Promise((resolve) => {
      let cancel = this.#later(ms, resolve);
      retries.hurry = () => {
        const soon = random() * FIRST_DELAY_MS;
        if (clock.now() + soon >= end) return;
        cancel();
        cancel = this.#later(soon, resolve);
        retries.hurry = () => undefined;
      };
    });
  }

  async #request(
    method: string,
    path: string,
    body: string | null,
    ms: number,
  ): Promise<HttpResponse> {
    const request = { method, url: this.#url + path, key: this.#key, body };
    const pending = this.#platform.request(request);
    const cancel = (): void => pending.cancel();
    const isLast = method === "DELETE";
    const cancelTimer = this.#platform.clock.after(ms, cancel);
    if (!isLast) this.#cancels.add(cancel);
    try {
      return await pending.response;
    } finally {
      cancelTimer();
      this.#cancels.delete(cancel);
    }
  }

  #delay(ms: number): Promise<void> {
    return new Promise((resolve) => this.#later(ms, resolve));
  }

  /** @returns a function that cancels the call */
  #later(ms: number, call: () => void): () => void {
    const done = (): void => {
      this.#cancels.delete(cancel);
      call();
    };
    const cancelTimer = this.#platform.clock.after(ms, done);
    // Delays that are cancelled never resolve: the connection is closed.
    const cancel = (): void => {
      this.#cancels.delete(cancel);
      cancelTimer();
    };
    this.#cancels.add(cancel);
    return cancel;
  }

  #lost(code: number): void {
    if (!this.#isOpen) return;
    this.#end();
    this.#events.closed(code);
  }

  #end(): void {
    this.#isOpen = false;
    for (const cancel of this.#cancels) cancel();
    this.#cancels.clear();
  }
}

function noFailure(): Retries {
  return { backoff: new Backoff(), isLost: false, hurry: () => undefined };
}

/** The close code that corresponds to an HTTP error. */
function codeOf(status: number, body: string): number {
  if (status === 401) return closeReasons.notAuthorised.code;
  // A 403 without a problem document comes from a proxy.
  if (status === 403 && body.includes("/problems/")) return closeReasons.forbidden.code;
  // Any other 404 comes from a proxy, or from a service without long polling.
  if (status === 404 && body.includes("/problems/no-robot")) return closeReasons.noRobot.code;
  if (status === 404 && body.includes("/problems/no-class")) return closeReasons.over.code;
  if (status === 429) return closeReasons.tooMany.code;
  return status === 503 ? closeReasons.restart.code : LOST;
}
