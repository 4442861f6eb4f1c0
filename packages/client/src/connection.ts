/**
 * One line to the relay that mends itself: greeting, welcome, silence, reconnect.
 *
 * It tries again after `RetryPauses`. Close codes that forbid a retry end the connection for good.
 *
 * Where the network lets no WebSocket through, the line goes on by plain HTTPS, and comes back to a
 * WebSocket when one can be opened.
 */
import {
  closeReasonOf,
  closeReasons,
  type CloseReason,
  type ReadResult,
  type SocketEvents,
  type SocketPort,
} from "@corridor/protocol";
import { DoorChoice, type Door } from "./transport-choice.ts";
import { HttpsLine, textOf, type Saying } from "./long-poll-connection.ts";
import type { Platform } from "./platform.ts";
import { RetryPauses } from "./backoff.ts";

/** From the first try to open until the welcome. */
const WELCOME_MS = 10_000;
/** The same where there is another way. */
const FALLBACK_MS = 4_000;
/** The relay speaks at least every 20 s. */
const SILENCE_MS = 45_000;

/** With any other code, something on the way closed the line, or it was lost. */
const ownCodes: ReadonlySet<number> = new Set(Object.values(closeReasons).map(({ code }) => code));

export type ConnectionStatus =
  | { kind: "connecting" }
  | { kind: "connected" }
  /** `retryMs`: pause until the next try */
  | { kind: "lost"; reason: CloseReason; retryMs: number }
  | { kind: "over"; reason: CloseReason };

export interface ConnectionOptions<In> {
  /** of the WebSocket, and of the line by HTTPS */
  urls: Record<Door, string>;
  platform: Omit<Platform, "uniqueText">;
  /** the first messages of each new socket */
  greeting: () => string[];
  decode: (text: string) => ReadResult<In>;
  /** A message. The welcome is told before the status, so that what it says already holds then. */
  received: (message: In) => void;
  changed: (status: ConnectionStatus) => void;
}

export class Connection<In extends { type: string }> {
  readonly #options: ConnectionOptions<In>;
  #socket: SocketPort | null = null;
  #isConnected = false;
  #isOver = false;
  readonly #pauses = new RetryPauses();
  readonly #choice = new DoorChoice();
  #connectedAt: number | null = null;
  #cancelProbe: () => void = () => undefined;
  #cancelTimer: () => void = () => undefined;

  constructor(options: ConnectionOptions<In>) {
    this.#options = options;
  }

  /** Whether the relay has said welcome on the line that is open now. */
  get isConnected(): boolean {
    return this.#isConnected;
  }

  /** The way that is in use. */
  get door(): Door {
    return this.#choice.door;
  }

  /** bytes that were sent but have not left this machine */
  get waitingBytes(): number {
    return this.#socket?.waitingBytes ?? 0;
  }

  /**
   * Opens the line at once: for the first time, again after `close`, or before the pause is over.
   * Does nothing while the line is open or being opened, and once it is over; but what a line by HTTPS
   * waits to ask again is asked soon.
   */
  open(): void {
    if (this.#socket instanceof HttpsLine) this.#socket.hurry();
    if (this.#isOver || this.#socket !== null) return;
    this.#cancelTimer();
    const { greeting, changed } = this.#options;
    changed({ kind: "connecting" });
    const socket = this.#openDoor({
      opened: () => {
        if (this.#socket === socket) for (const text of greeting()) socket.send(text);
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

  /** Sends a message on the open line. Whoever calls keeps what must survive a lost line. */
  send(saying: Saying): void {
    if (!this.#isConnected) return;
    if (this.#socket instanceof HttpsLine) this.#socket.send(saying);
    else this.#socket?.send(textOf(saying));
  }

  /** Closes the line. Nothing is reported and nothing is tried until `open` is called again. */
  close(): void {
    this.#drop();
  }

  #received(text: string): void {
    const { decode, received, changed } = this.#options;
    this.#expect(SILENCE_MS);
    const message = decode(text);
    // A message of a newer relay: what cannot be read cannot be acted on.
    if (!message.ok) return;
    const isWelcome = message.value.type === "welcome" && !this.#isConnected;
    if (isWelcome) {
      this.#isConnected = true;
      this.#pauses.beginAnew();
      this.#connectedAt = this.#options.platform.clock.now();
      this.#choice.welcomed();
      if (this.#choice.door === "https") this.#probeLater();
    }
    received(message.value);
    if (isWelcome) changed({ kind: "connected" });
  }

  /** The next message must come within so many ms, or the line counts as lost. */
  #expect(ms: number): void {
    this.#cancelTimer();
    this.#cancelTimer = this.#options.platform.clock.after(ms, () =>
      this.#lost(closeReasonOf(1006)),
    );
  }

  /** Whether the WebSocket that is being opened is not the only way. */
  get #canFallBack(): boolean {
    return this.#choice.door === "websocket" && this.#options.platform.ask !== undefined;
  }

  #openDoor(events: SocketEvents): SocketPort {
    const { urls, platform } = this.#options;
    const { ask } = platform;
    if (this.#choice.door === "websocket" || ask === undefined) {
      return platform.connect(urls.websocket, events);
    }
    return new HttpsLine(urls.https, { ...platform, ask }, events);
  }

  /** Looks from time to time whether a WebSocket can be opened again, and moves over to it. */
  #probeLater(): void {
    const { urls, platform } = this.#options;
    this.#cancelProbe = platform.clock.after(this.#choice.probeMs, () => {
      let isDone = false;
      const over = (isOpen: boolean): void => {
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
        opened: () => over(true),
        received: () => undefined,
        closed: () => over(false),
      });
      const cancelTimer = platform.clock.after(FALLBACK_MS, () => over(false));
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
    const livedMs = connectedAt === null ? null : platform.clock.now() - connectedAt;
    const isDeliberate = platform.ask === undefined || ownCodes.has(reason.code);
    if (this.#choice.lost({ livedMs, isDeliberate })) {
      if (livedMs !== null) changed({ kind: "lost", reason, retryMs: 0 });
      return this.open();
    }
    const retryMs = this.#pauses.next(platform.clock.now(), platform.random());
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
