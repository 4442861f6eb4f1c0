/**
 * One line to the relay that mends itself: greeting, welcome, silence, reconnect.
 *
 * The pause before a new try is drawn from 0 to a limit that doubles from 0.25 s to 10 s (full
 * jitter), so that a whole class does not come back in the same moment. Close codes that forbid a
 * retry end the connection for good.
 */
import {
  closeReasonOf,
  type CloseReason,
  type ReadResult,
  type SocketPort,
} from "@corridor/protocol";
import type { Platform } from "./platform.ts";

const FIRST_PAUSE_MS = 250;
const LONGEST_PAUSE_MS = 10_000;
/** From the first try to open until the welcome. */
const WELCOME_MS = 10_000;
/** The relay speaks at least every 20 s. */
const SILENCE_MS = 45_000;

export type ConnectionStatus =
  | { kind: "connecting" }
  | { kind: "connected" }
  /** `retryMs`: pause until the next try */
  | { kind: "lost"; reason: CloseReason; retryMs: number }
  | { kind: "over"; reason: CloseReason };

export interface ConnectionOptions<In> {
  url: string;
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
  #lostInARow = 0;
  #cancelTimer: () => void = () => undefined;

  constructor(options: ConnectionOptions<In>) {
    this.#options = options;
  }

  /** Whether the relay has said welcome on the line that is open now. */
  get isConnected(): boolean {
    return this.#isConnected;
  }

  /** bytes that were sent but have not left this machine */
  get waitingBytes(): number {
    return this.#socket?.waitingBytes ?? 0;
  }

  /**
   * Opens the line at once: for the first time, again after `close`, or before the pause is over.
   * Does nothing while the line is open or being opened, and once it is over.
   */
  open(): void {
    if (this.#isOver || this.#socket !== null) return;
    this.#cancelTimer();
    const { url, platform, greeting, changed } = this.#options;
    changed({ kind: "connecting" });
    const socket = platform.connect(url, {
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
    this.#expect(WELCOME_MS);
  }

  /** Sends a message on the open line. Whoever calls keeps what must survive a lost line. */
  send(text: string): void {
    if (this.#isConnected) this.#socket?.send(text);
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
      this.#lostInARow = 0;
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

  #lost(reason: CloseReason): void {
    this.#drop();
    const { platform, changed } = this.#options;
    if (!reason.retry) {
      this.#isOver = true;
      return changed({ kind: "over", reason });
    }
    const limit = Math.min(LONGEST_PAUSE_MS, FIRST_PAUSE_MS * 2 ** this.#lostInARow);
    this.#lostInARow += 1;
    const retryMs = platform.random() * limit;
    this.#cancelTimer = platform.clock.after(retryMs, () => this.open());
    return changed({ kind: "lost", reason, retryMs });
  }

  #drop(): void {
    this.#cancelTimer();
    const socket = this.#socket;
    this.#socket = null;
    this.#isConnected = false;
    socket?.close(1000, "");
  }
}
