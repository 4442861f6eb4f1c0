/**
 * A socket out of plain HTTPS requests: what is sent is posted, what comes is fetched by long poll. Every
 * message has a number on its way, so a request that failed is made again and nothing is doubled.
 */
import {
  closeReasons,
  fetchedMessagesSchema,
  MAX_FRAME_BYTES,
  MAX_LONG_POLL_MESSAGES,
  openedConnectionSchema,
  readJson,
  takenMessagesSchema,
  type SocketEvents,
  type SocketPort,
} from "@corridor/protocol";
import type { Ask, Platform } from "./platform.ts";
import { FIRST_PAUSE_MS, RetryPauses } from "./backoff.ts";

/** Longest wait of a fetch, in seconds, as the relay allows it. */
const LONGEST_WAIT = 25;
const SHORTEST_WAIT = 1;
/** On top of the wait, for the way there and back. */
const ANSWER_MS = 8_000;
/** Between two posts: what comes meanwhile goes together. */
const PACE_MS = 50;
/** The relay closes a line that is silent for 15 s. */
const GIVE_UP_MS = 12_000;
/** Room for the number and the brackets. */
const MAX_BATCH = MAX_FRAME_BYTES - 64;
const MAX_ANSWER = 1024 * 1024;

/** The connection was lost. */
const LOST = 1006;

/**
 * A message, or how it reads in the moment in which it leaves: what tells its own age is said anew with
 * each try.
 */
export type Saying = string | (() => string);

export function textOf(saying: Saying): string {
  return typeof saying === "string" ? saying : saying();
}

/** One of the two requests of which a line is made, while it fails. */
interface Retries {
  readonly pauses: RetryPauses;
  /** the last one got no answer at all */
  isLost: boolean;
  /** cuts the pause that it makes now to a short one */
  hurry(): void;
}

type HttpsPlatform = Pick<Platform, "clock" | "random"> & { ask: Ask };

export class HttpsLine implements SocketPort {
  readonly #url: string;
  readonly #platform: HttpsPlatform;
  readonly #events: SocketEvents;
  #key: string | null = null;
  /** not known to be taken, oldest first, and the number of the first */
  #queue: Saying[] = [];
  #first = 1;
  #isPosting = false;
  #isOpen = true;
  /** number of the newest message that has come */
  #after = 0;
  #wait = LONGEST_WAIT;
  readonly #posts = noFailure();
  readonly #fetches = noFailure();
  readonly #cancels = new Set<() => void>();

  /**
   * Opens a line. Nothing is reported before the constructor has returned.
   * @param url `https://HOST/api/v1/robots/ID/long-poll`
   */
  constructor(url: string, platform: HttpsPlatform, events: SocketEvents) {
    this.#url = url;
    this.#platform = platform;
    this.#events = events;
    this.#later(0, () => events.opened());
  }

  get isOpen(): boolean {
    return this.#isOpen;
  }

  get waitingBytes(): number {
    return this.#queue.reduce((sum, saying) => sum + textOf(saying).length, 0);
  }

  /** Sends one message; the first is the hello that opens the line. */
  send(saying: Saying): void {
    if (!this.#isOpen) return;
    if (this.#key === null && !this.#isPosting) {
      this.#isPosting = true;
      void this.#hello(textOf(saying));
      return;
    }
    this.#queue.push(saying);
    void this.#post();
  }

  close(): void {
    if (this.#isOpen && this.#key !== null)
      this.#ask("DELETE", "", null, ANSWER_MS).catch(() => null);
    this.#end();
  }

  /** The net may be back: what waits to be asked again is asked soon. */
  hurry(): void {
    for (const retries of [this.#posts, this.#fetches]) {
      if (!retries.isLost) continue;
      retries.pauses.beginAnew();
      retries.hurry();
    }
  }

  async #hello(text: string): Promise<void> {
    try {
      const { status, body } = await this.#ask("POST", "", text, ANSWER_MS);
      if (!this.#isOpen) return;
      const opened = readJson(openedConnectionSchema, body, MAX_ANSWER);
      if (status !== 201 || !opened.ok) return this.#lost(codeOf(status, body));
      this.#key = opened.value.key;
    } catch {
      return this.#lost(LOST);
    }
    this.#isPosting = false;
    void this.#fetch();
    void this.#post();
  }

  /** Sends what waits, until nothing does. */
  async #post(): Promise<void> {
    if (this.#isPosting || this.#key === null) return;
    this.#isPosting = true;
    while (this.#isOpen && this.#queue.length > 0) {
      const sent = await this.#stubbornly(this.#posts, () => {
        const body = `{"first":${this.#first},"messages":[${this.#batch().join()}]}`;
        return this.#ask("POST", "/messages", body, ANSWER_MS);
      });
      if (sent === null || !this.#isOpen) return;
      const answer = readJson(takenMessagesSchema, sent.body, MAX_ANSWER);
      if (!answer.ok) return this.#lost(LOST);
      const count = answer.value.taken - this.#first + 1;
      // A relay that takes none of it, or knows of more, is not the one that this line was opened at.
      if (count <= 0 || count > this.#queue.length) return this.#lost(LOST);
      this.#queue.splice(0, count);
      this.#first += count;
      await this.#pause(PACE_MS);
    }
    this.#isPosting = false;
  }

  #batch(): string[] {
    let characters = 0;
    const texts = this.#queue.slice(0, MAX_LONG_POLL_MESSAGES).map(textOf);
    const fitting = texts.findIndex((text) => (characters += text.length + 1) > MAX_BATCH);
    return fitting < 0 ? texts : texts.slice(0, Math.max(1, fitting));
  }

  /** Fetches what comes, for as long as the line is open. */
  async #fetch(): Promise<void> {
    while (this.#isOpen) {
      const answer = await this.#stubbornly(this.#fetches, () => this.#fetchOnce());
      if (answer === null || !this.#isOpen) return;
      const fetched = readJson(fetchedMessagesSchema, answer.body, MAX_ANSWER);
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

  async #fetchOnce(): Promise<Answer> {
    const begun = this.#platform.clock.now();
    const query = `/messages?after=${this.#after}&wait=${this.#wait}`;
    try {
      return await this.#ask("GET", query, null, this.#wait * 1_000 + ANSWER_MS);
    } catch (error) {
      // Something on the way ends requests that wait for long: the next one waits for less.
      const seconds = (this.#platform.clock.now() - begun) / 1_000;
      if (seconds > SHORTEST_WAIT) {
        this.#wait = Math.max(SHORTEST_WAIT, Math.floor(Math.min(seconds, this.#wait) * 0.7));
      }
      throw error;
    }
  }

  /** Makes a request again while it fails, unless that is for good. @returns null when the line is lost */
  async #stubbornly(retries: Retries, ask: () => Promise<Answer>): Promise<Answer | null> {
    let failedSince: number | null = null;
    while (this.#isOpen) {
      const begun = this.#platform.clock.now();
      const answer = await ask().catch(() => null);
      if (!this.#isOpen) return null;
      if (answer?.status === 200) {
        retries.isLost = false;
        retries.pauses.beginAnew();
        // The net is back: the other request need not wait any longer to find out for itself.
        this.hurry();
        return answer;
      }
      const isForGood = answer !== null && answer.status < 500 && answer.status !== 429;
      const now = this.#platform.clock.now();
      failedSince ??= answer === null ? begun : now;
      // A request that waited in vain for long has not shown that the line is gone: the next one does.
      if (now - begun > GIVE_UP_MS / 2) {
        failedSince = now;
        retries.pauses.beginAnew();
      }
      if (isForGood || now - failedSince > GIVE_UP_MS) {
        this.#lost(LOST);
        return null;
      }
      retries.isLost = answer === null;
      await this.#pauseBefore(retries, retries.pauses.next(now, this.#platform.random()));
    }
    return null;
  }

  #pauseBefore(retries: Retries, ms: number): Promise<void> {
    const { clock, random } = this.#platform;
    const end = clock.now() + ms;
    return new Promise((resolve) => {
      let callOff = this.#later(ms, resolve);
      retries.hurry = () => {
        const soon = random() * FIRST_PAUSE_MS;
        if (clock.now() + soon >= end) return;
        callOff();
        callOff = this.#later(soon, resolve);
        retries.hurry = () => undefined;
      };
    });
  }

  async #ask(method: string, path: string, body: string | null, ms: number): Promise<Answer> {
    const request = { method, url: this.#url + path, key: this.#key, body };
    const asked = this.#platform.ask(request);
    const cancel = (): void => asked.cancel();
    const isLast = method === "DELETE";
    const cancelTimer = this.#platform.clock.after(ms, cancel);
    if (!isLast) this.#cancels.add(cancel);
    try {
      return await asked.answer;
    } finally {
      cancelTimer();
      this.#cancels.delete(cancel);
    }
  }

  #pause(ms: number): Promise<void> {
    return new Promise((resolve) => this.#later(ms, resolve));
  }

  /** @returns a function that calls it off */
  #later(ms: number, call: () => void): () => void {
    const done = (): void => {
      this.#cancels.delete(cancel);
      call();
    };
    const cancelTimer = this.#platform.clock.after(ms, done);
    // Whoever pauses finds the line closed, and goes no further.
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
  return { pauses: new RetryPauses(), isLost: false, hurry: () => undefined };
}

interface Answer {
  status: number;
  body: string;
}

/** The close code that a WebSocket would have had. */
function codeOf(status: number, body: string): number {
  if (status === 401) return closeReasons.notAuthorised.code;
  // Any other 403 comes from something on the way, not from a relay that forbids this or sends away.
  if (status === 403 && body.includes("/problems/")) return closeReasons.forbidden.code;
  // Any other 404 comes from something on the way, or from a service without lines.
  if (status === 404 && body.includes("/problems/no-robot")) return closeReasons.noRobot.code;
  if (status === 429) return closeReasons.tooMany.code;
  return status === 503 ? closeReasons.restart.code : LOST;
}
