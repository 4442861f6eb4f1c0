/**
 * A long-poll connection with the interface of a socket. Sent messages are buffered until a request
 * fetches them, and deleted when the next request acknowledges them. Each posted message is
 * processed once.
 */
import {
  closeReasons,
  MAX_LONG_POLL_MESSAGES,
  type FetchedMessages,
  type SentMessages,
  type TakenMessages,
} from "@corridor/protocol";
import { Refusal } from "../../platform/errors/problems.ts";
import type { Clock } from "../../platform/time/clock.ts";
import type { WaitLimit } from "../../platform/time/wait-limit.ts";
import type { CarriedSnapshot } from "../../bus/carried-snapshot.ts";
import { limits } from "../../platform/limits/limits.ts";
import {
  closeWith,
  handleMessage,
  type Conversation,
  type ClientConnection,
} from "../conversations/conversation.ts";

/**
 * Size limit of a response with several messages, because clients read a response only as a whole.
 */
const MAX_ANSWER_CHARACTERS = 64 * 1024;

export interface LongPollConnectionParts {
  /** of the robot or the class */
  id: string;
  /** client address, for the limit only */
  address: string;
  clock: Clock;
  /** Called on each request, as a sign of life. */
  onRequest(): void;
  /** Called when the connection has ended. */
  onEnded(): void;
  /** Called with the error of each message that failed. */
  onError(error: unknown): void;
}

export class LongPollConnection implements ClientConnection {
  readonly transport = "long-poll-connection";
  readonly id: string;
  readonly address: string;
  readonly #clock: Clock;
  readonly #onRequest: () => void;
  readonly #onEnded: () => void;
  readonly #onError: (error: unknown) => void;
  #conversation: Conversation | null = null;
  /** unacknowledged messages, oldest first, and the number of the first */
  #unacknowledged: string[] = [];
  #first = 1;
  #sentBytes = 0;
  #takenBytes = 0;
  /** number of the last message received from the client */
  #lastReceived = 0;
  #closing: { code: number; reason: string } | null = null;
  /** the client can no longer fetch why it was closed */
  #isDropped = false;
  #wake: () => void = () => undefined;
  #requests = 0;
  #cancelTimer: () => void = () => undefined;

  constructor(parts: LongPollConnectionParts) {
    this.id = parts.id;
    this.address = parts.address;
    this.#clock = parts.clock;
    this.#onRequest = () => parts.onRequest();
    this.#onEnded = () => parts.onEnded();
    this.#onError = (error) => parts.onError(error);
    this.#awaitRequest();
  }

  readonly flow = ((connection: LongPollConnection) => ({
    get sentBytes() {
      return connection.#sentBytes;
    },
    get takenBytes() {
      return connection.#takenBytes;
    },
    ask: () => undefined,
    isProof: true,
  }))(this);

  get isOpen(): boolean {
    return this.#closing === null;
  }

  get waitingBytes(): number {
    return this.#sentBytes - this.#takenBytes;
  }

  /** Starts the conversation. Messages are ignored before. */
  start(conversation: Conversation): void {
    this.#conversation = conversation;
  }

  send(...texts: string[]): void {
    if (!this.isOpen) return;
    if (this.waitingBytes > limits.stuckReaderBytes) return closeWith(this, closeReasons.tooSlow);
    this.#unacknowledged.push(...texts);
    for (const { length } of texts) this.#sentBytes += length;
    this.#wake();
  }

  sendSnapshot({ message }: CarriedSnapshot): void {
    this.send(message.toString());
  }

  /** Ends the conversation. The client receives the reason with its next request. */
  close(code: number, reason: string): void {
    this.#close(code, reason, false);
  }

  #close(code: number, reason: string, isClosedByClient: boolean): void {
    if (!this.isOpen) return;
    this.#closing = { code, reason };
    // Deferred, because the caller may be in the middle of a change that the closing is part of.
    queueMicrotask(() => this.#conversation?.closed(isClosedByClient));
    this.#wake();
    if (this.#requests === 0) this.#awaitRequest();
  }

  heartbeat(): void {
    if (this.isOpen) this.#conversation?.heartbeat();
  }

  /**
   * Processes messages of the client, each once.
   * @returns the number of the last message received; lower than sent if some are missing
   * @throws Refusal no-connection if it ended while the request was read
   */
  receive({ first, messages }: SentMessages): TakenMessages {
    if (this.#isDropped) throw noConnection();
    this.#onRequest();
    for (const [index, message] of messages.entries()) {
      if (first + index !== this.#lastReceived + 1 || !this.isOpen) continue;
      this.#lastReceived += 1;
      if (this.#conversation !== null) {
        handleMessage(this.#conversation, Buffer.from(JSON.stringify(message)), this.#onError);
      }
    }
    this.#awaitRequest();
    return { taken: this.#lastReceived };
  }

  /** Returns the messages after an acknowledged number. Waits if there are none. */
  async fetch(after: number, waitLimit: WaitLimit): Promise<FetchedMessages> {
    // A repeated request replaces the previous one.
    this.#wake();
    this.#onRequest();
    this.#acknowledge(after);
    if (this.#unacknowledged.length === 0 && this.isOpen) await this.#waitForMessages(waitLimit);
    let characters = 0;
    const messages = this.#unacknowledged
      .slice(0, MAX_LONG_POLL_MESSAGES)
      .filter((text, index) => (characters += text.length) <= MAX_ANSWER_CHARACTERS || index === 0);
    const isLast = messages.length === this.#unacknowledged.length;
    return {
      first: this.#first,
      messages: messages.map((text) => JSON.parse(text) as { type: string }),
      closed: isLast ? this.#closing : null,
    };
  }

  /** Ends the connection at the client's request. */
  leave(): void {
    this.#close(closeReasons.restart.code, "", true);
    this.drop();
  }

  /** Ends the connection immediately, without notice. */
  drop(): void {
    if (this.isOpen) this.close(closeReasons.restart.code, "");
    this.#isDropped = true;
    this.#cancelTimer();
    this.#onEnded();
  }

  #acknowledge(after: number): void {
    const count = Math.min(after - this.#first + 1, this.#unacknowledged.length);
    if (count <= 0) return;
    for (const text of this.#unacknowledged.splice(0, count)) this.#takenBytes += text.length;
    this.#first += count;
  }

  async #waitForMessages({ milliseconds, signal }: WaitLimit): Promise<void> {
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

  /** Drops the connection if the client makes no request for a while. */
  #awaitRequest(): void {
    this.#cancelTimer();
    if (this.#requests > 0 || this.#isDropped) return;
    this.#cancelTimer = this.#clock.after(limits.longPollSilenceMs, () => this.drop());
  }
}

/** Error response if there is no such connection, or no longer. */
export function noConnection(): Refusal {
  return new Refusal(
    "no-connection",
    "The connection was idle for too long, or the relay was restarted. Open a new one.",
  );
}
