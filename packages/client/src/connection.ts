import {
  closeReasonOf,
  closeReasons,
  SILENCE_MS,
  type CloseReason,
  type ReadResult,
  type SocketEvents,
  type SocketPort,
} from "@corridor/protocol";
import { TransportChoice, type Transport } from "./transport-choice.ts";
import { LongPollConnection, textOf, type OutgoingMessage } from "./long-poll-connection.ts";
import type { Platform } from "./platform.ts";
import { Backoff } from "./backoff.ts";

/** Timeout from opening until the welcome. */
const WELCOME_MS = 10_000;
/** The same if there is another transport. */
const FALLBACK_MS = 4_000;

/** With any other code, a proxy closed the connection, or it was lost. */
const ownCodes: ReadonlySet<number> = new Set(Object.values(closeReasons).map(({ code }) => code));

export type ConnectionStatus =
  | { kind: "connecting" }
  | { kind: "connected" }
  /** `retryMs`: delay until the next attempt */
  | { kind: "lost"; reason: CloseReason; retryMs: number }
  | { kind: "over"; reason: CloseReason };

export interface ConnectionOptions<In> {
  /** by transport */
  urls: Record<Transport, string>;
  platform: Omit<Platform, "uniqueText">;
  /** creates the first messages of each new connection */
  firstMessages: () => string[];
  decode: (text: string) => ReadResult<In>;
  /** Receives each message. Called for the welcome before `changed`. */
  received: (message: In) => void;
  changed: (status: ConnectionStatus) => void;
}

/**
 * A connection to the relay that reconnects automatically, with `Backoff`, after it was lost. Close
 * codes without retry end it. If the network blocks WebSockets, it uses long polling until a
 * WebSocket can be opened.
 */
export class Connection<In extends { type: string }> {
  readonly #options: ConnectionOptions<In>;
  #socket: SocketPort | null = null;
  #isConnected = false;
  #isOver = false;
  readonly #backoff = new Backoff();
  readonly #choice = new TransportChoice();
  #connectedAt: number | null = null;
  #cancelProbe: () => void = () => undefined;
  #cancelTimer: () => void = () => undefined;

  constructor(options: ConnectionOptions<In>) {
    this.#options = options;
  }

  /** Whether the relay has sent its welcome on the current connection. */
  get isConnected(): boolean {
    return this.#isConnected;
  }

  /** The transport in use. */
  get transport(): Transport {
    return this.#choice.transport;
  }

  /** bytes that were sent and are still buffered on this machine */
  get waitingBytes(): number {
    return this.#socket?.waitingBytes ?? 0;
  }

  /**
   * Connects at once: for the first time, after `close`, or instead of waiting for the next attempt.
   * Does nothing while the connection is open or opening, or after it has ended, except that a
   * long-poll connection repeats failed requests soon.
   */
  open(): void {
    if (this.#socket instanceof LongPollConnection) this.#socket.hurry();
    if (this.#isOver || this.#socket !== null) return;
    this.#cancelTimer();
    const { firstMessages, changed } = this.#options;
    changed({ kind: "connecting" });
    const socket = this.#openTransport({
      opened: () => {
        if (this.#socket === socket) for (const text of firstMessages()) socket.send(text);
      },
      received: (text) => {
        if (this.#socket === socket) this.#received(text);
      },
      closed: (code) => {
        if (this.#socket === socket) this.#lost(closeReasonOf(code));
      },
    });
    this.#socket = socket;
    this.#expect(this.#canFallBack ? FALLBACK_MS : WELCOME_MS);
  }

  /** Sends a message; drops it while there is no connection. */
  send(message: OutgoingMessage): void {
    if (!this.#isConnected) return;
    if (this.#socket instanceof LongPollConnection) this.#socket.send(message);
    else this.#socket?.send(textOf(message));
  }

  /** Closes the connection without a status, until `open` is called again. */
  close(): void {
    this.#drop();
  }

  #received(text: string): void {
    const { decode, received, changed } = this.#options;
    this.#expect(SILENCE_MS);
    const message = decode(text);
    // Ignores messages of newer relays.
    if (!message.ok) return;
    const isWelcome = message.value.type === "welcome" && !this.#isConnected;
    if (isWelcome) {
      this.#isConnected = true;
      this.#backoff.reset();
      this.#connectedAt = this.#options.platform.clock.now();
      this.#choice.welcomed();
      if (this.#choice.transport === "long-poll") this.#probeLater();
    }
    received(message.value);
    if (isWelcome) changed({ kind: "connected" });
  }

  /** The connection counts as lost if no message arrives within `ms`. */
  #expect(ms: number): void {
    this.#cancelTimer();
    this.#cancelTimer = this.#options.platform.clock.after(ms, () =>
      this.#lost(closeReasonOf(1006)),
    );
  }

  /** Whether there is another transport than the current WebSocket. */
  get #canFallBack(): boolean {
    return this.#choice.transport === "websocket" && this.#options.platform.request !== undefined;
  }

  #openTransport(events: SocketEvents): SocketPort {
    const { urls, platform } = this.#options;
    const { request } = platform;
    if (this.#choice.transport === "websocket" || request === undefined) {
      return platform.connect(urls.websocket, events);
    }
    return new LongPollConnection(urls["long-poll"], { ...platform, request }, events);
  }

  /** Probes periodically for a WebSocket, and reconnects by it. */
  #probeLater(): void {
    const { urls, platform } = this.#options;
    this.#cancelProbe = platform.clock.after(this.#choice.probeMs, () => {
      let isDone = false;
      const finish = (isOpen: boolean): void => {
        if (isDone) return;
        this.#cancelProbe();
        if (!isOpen) {
          this.#choice.websocketFailed();
          return this.#probeLater();
        }
        this.#choice.websocketOpened();
        this.#drop();
        return this.open();
      };
      const probe = platform.connect(urls.websocket, {
        opened: () => finish(true),
        received: () => undefined,
        closed: () => finish(false),
      });
      const cancelTimer = platform.clock.after(FALLBACK_MS, () => finish(false));
      this.#cancelProbe = () => {
        isDone = true;
        this.#cancelProbe = () => undefined;
        cancelTimer();
        probe.close(1000, "");
      };
    });
  }

  #lost(reason: CloseReason): void {
    const { platform, changed } = this.#options;
    const connectedAt = this.#isConnected ? this.#connectedAt : null;
    this.#drop();
    if (!reason.retry) {
      this.#isOver = true;
      return changed({ kind: "over", reason });
    }
    const lifetimeMs = connectedAt === null ? null : platform.clock.now() - connectedAt;
    const isDeliberate = platform.request === undefined || ownCodes.has(reason.code);
    if (this.#choice.lost({ lifetimeMs, isDeliberate })) {
      if (lifetimeMs !== null) changed({ kind: "lost", reason, retryMs: 0 });
      return this.open();
    }
    const retryMs = this.#backoff.next(platform.clock.now(), platform.random());
    this.#cancelTimer = platform.clock.after(retryMs, () => this.open());
    return changed({ kind: "lost", reason, retryMs });
  }

  #drop(): void {
    this.#cancelTimer();
    this.#cancelProbe();
    const socket = this.#socket;
    this.#socket = null;
    this.#isConnected = false;
    socket?.close(1000, "");
  }
}
