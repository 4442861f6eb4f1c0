/**
 * One line by plain HTTPS, as a socket: what is sent waits here until a request fetches it, and is
 * forgotten when the next request says that it came. What the other side posts is taken once.
 */
import { closeReasons, MAX_LINE_MESSAGES, type FetchedMessages } from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import type { Patience } from "../sessions/audience.ts";
import type { CarriedSnapshot } from "../sessions/carried-snapshot.ts";
import { limits } from "../sessions/limits.ts";
import { closeWith, hear, type Conversation } from "./conversation.ts";
import type { ReaderLine } from "./reader-line.ts";

/** A longer answer would be cut by nobody, and read by nobody before its end. */
const MAX_ANSWER_CHARACTERS = 64 * 1024;

export interface LineParts {
  /** whose line it is */
  robot: string;
  /** of the other side, for the limit only */
  address: string;
  clock: Clock;
  /** Each request is a sign of life. */
  onRequest(): void;
  /** The line is over for good. */
  onGone(): void;
}

export class HttpLine implements ReaderLine {
  readonly door = "line";
  readonly robot: string;
  readonly address: string;
  readonly #clock: Clock;
  readonly #onRequest: () => void;
  readonly #onGone: () => void;
  #conversation: Conversation | null = null;
  /** not known to have come, oldest first, and the number of the first */
  #waiting: string[] = [];
  #first = 1;
  #sentBytes = 0;
  #takenBytes = 0;
  /** number of the newest message that was taken from the other side */
  #heard = 0;
  #end: { code: number; reason: string } | null = null;
  #wake: () => void = () => undefined;
  #requests = 0;
  #cancelTimer: () => void = () => undefined;

  constructor(parts: LineParts) {
    this.robot = parts.robot;
    this.address = parts.address;
    this.#clock = parts.clock;
    this.#onRequest = () => parts.onRequest();
    this.#onGone = () => parts.onGone();
    this.#awaitRequest();
  }

  readonly flow = ((line: HttpLine) => ({
    get sentBytes() {
      return line.#sentBytes;
    },
    get takenBytes() {
      return line.#takenBytes;
    },
    ask: () => undefined,
    isProof: true,
  }))(this);

  get isOpen(): boolean {
    return this.#end === null;
  }

  get waitingBytes(): number {
    return this.#sentBytes - this.#takenBytes;
  }

  /** Who is spoken with; nothing is taken before. */
  begin(conversation: Conversation): void {
    this.#conversation = conversation;
  }

  send(...texts: string[]): void {
    if (!this.isOpen) return;
    if (this.waitingBytes > limits.stuckReaderBytes) return closeWith(this, closeReasons.tooSlow);
    this.#waiting.push(...texts);
    for (const { length } of texts) this.#sentBytes += length;
    this.#wake();
  }

  pass({ message }: CarriedSnapshot): void {
    this.send(message.toString());
  }

  /** The conversation ends now; the other side learns it by its next request. */
  close(code: number, reason: string): void {
    this.#close(code, reason, false);
  }

  #close(code: number, reason: string, saidGoodbye: boolean): void {
    if (!this.isOpen) return;
    this.#end = { code, reason };
    // Not now: whoever closes it may be in the midst of a change that the goodbye is part of.
    queueMicrotask(() => this.#conversation?.closed(saidGoodbye));
    this.#wake();
    if (this.#requests === 0) this.#awaitRequest();
  }

  heartbeat(): void {
    if (this.isOpen) this.#conversation?.heartbeat();
  }

  /**
   * Takes messages of the other side, each once.
   * @param failed is told of each that could not be served
   * @returns the number of the newest that was taken; less than was sent where some are missing
   */
  take(first: number, messages: readonly unknown[], failed: (error: unknown) => void): number {
    this.#onRequest();
    for (const [index, message] of messages.entries()) {
      if (first + index !== this.#heard + 1 || !this.isOpen) continue;
      this.#heard += 1;
      if (this.#conversation !== null) {
        hear(this.#conversation, Buffer.from(JSON.stringify(message)), failed);
      }
    }
    this.#awaitRequest();
    return this.#heard;
  }

  /** What was sent after a number that has come; waits for it while there is nothing. */
  async fetch(after: number, patience: Patience): Promise<FetchedMessages> {
    // A request that is made anew takes the place of the one before.
    this.#wake();
    this.#onRequest();
    this.#came(after);
    if (this.#waiting.length === 0 && this.isOpen) await this.#something(patience);
    let characters = 0;
    const messages = this.#waiting
      .slice(0, MAX_LINE_MESSAGES)
      .filter((text) => (characters += text.length) <= MAX_ANSWER_CHARACTERS);
    const isLast = messages.length === this.#waiting.length;
    return {
      first: this.#first,
      messages: messages.map((text) => JSON.parse(text) as { type: string }),
      closed: isLast ? this.#end : null,
    };
  }

  /** The other side ends the line. */
  leave(): void {
    this.#close(closeReasons.restart.code, "", true);
    this.drop();
  }

  /** Ends the line at once, unheard. */
  drop(): void {
    if (this.isOpen) this.close(closeReasons.restart.code, "");
    this.#cancelTimer();
    this.#onGone();
  }

  #came(after: number): void {
    const count = Math.min(after - this.#first + 1, this.#waiting.length);
    if (count <= 0) return;
    for (const text of this.#waiting.splice(0, count)) this.#takenBytes += text.length;
    this.#first += count;
  }

  async #something({ milliseconds, signal }: Patience): Promise<void> {
    if (milliseconds === 0 || signal.aborted) return;
    const { promise, resolve } = Promise.withResolvers<void>();
    this.#wake = resolve;
    this.#requests += 1;
    this.#cancelTimer();
    const cancelTimer = this.#clock.after(milliseconds, resolve);
    signal.addEventListener("abort", () => resolve(), { once: true });
    await promise;
    cancelTimer();
    this.#requests -= 1;
    this.#awaitRequest();
  }

  /** Whoever makes no request for a while is gone. */
  #awaitRequest(): void {
    this.#cancelTimer();
    if (this.#requests > 0) return;
    this.#cancelTimer = this.#clock.after(limits.lineSilenceMs, () => this.drop());
  }
}
