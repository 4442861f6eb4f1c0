/**
 * Adapter from a `ws` socket to the connection that the rest of the relay uses. Every message
 * passes through it, so that its buffer limit covers all of them. (`ws` limits pongs itself.)
 *
 * Messages are written as whole frames, in one write each, to the connection below `ws`. Pings,
 * pongs and close frames, which `ws` writes, keep their order, because `ws` buffers nothing while
 * compression is off.
 *
 * Pings measure what the client has received: its WebSocket library answers each ping
 * automatically, after all earlier messages.
 */
import type { Duplex } from "node:stream";
import { closeReasons } from "@corridor/protocol";
import type { WebSocket } from "ws";
import type { Clock } from "../../platform/time/clock.ts";
import { limits } from "../../platform/limits/limits.ts";
import { textFrame } from "../../platform/text-frame.ts";
import type { CarriedSnapshot } from "../../bus/carried-snapshot.ts";
import type { ReaderFlow } from "../../robots/readers/feed.ts";
import { closeWith, type ClientConnection } from "../conversations/conversation.ts";

/**
 * A class, because a relay has thousands of instances. An object of closures and getters takes five
 * times the memory.
 */
export class WsPort implements ClientConnection, ReaderFlow {
  readonly transport = "websocket";
  readonly isProof = true;
  sentBytes = 0;
  takenBytes = 0;
  readonly #socket: WebSocket;
  readonly #connection: Duplex;
  readonly #clock: Clock;
  /** bytes sent before the unanswered ping */
  #pingedBytes: number | null = null;
  #mustPingAgain = false;

  /**
   * @param connection carries the socket's frames, unfragmented and uncompressed
   * @param clock measures the time limit of the closing handshake
   */
  constructor(socket: WebSocket, connection: Duplex, clock: Clock) {
    this.#socket = socket;
    this.#connection = connection;
    this.#clock = clock;
    socket.on("pong", (data: Buffer) => this.#onPong(data));
  }

  get flow(): ReaderFlow {
    return this;
  }

  get isOpen(): boolean {
    return this.#socket.readyState === this.#socket.OPEN;
  }

  get waitingBytes(): number {
    return this.#connection.writableLength;
  }

  send(...texts: string[]): void {
    if (!this.#canSend()) return;
    const [frame, ...more] = texts.map(textFrame);
    if (frame !== undefined)
      this.#write(more.length === 0 ? frame : Buffer.concat([frame, ...more]));
  }

  sendSnapshot({ frame }: CarriedSnapshot): void {
    if (this.#canSend()) this.#write(frame);
  }

  close(code: number, reason: string): void {
    if (!this.isOpen) return;
    this.#socket.close(code, reason);
    // A client that does not read does not answer the close frame either.
    this.#socket.once(
      "close",
      this.#clock.after(limits.closingMs, () => this.#socket.terminate()),
    );
  }

  ask(): void {
    this.#mustPingAgain = this.#pingedBytes !== null;
    if (this.#mustPingAgain || !this.isOpen) return;
    this.#pingedBytes = this.sentBytes;
    this.#socket.ping(String(this.#pingedBytes));
  }

  #canSend(): boolean {
    if (!this.isOpen) return false;
    if (this.waitingBytes <= limits.stuckReaderBytes) return true;
    closeWith(this, closeReasons.tooSlow);
    return false;
  }

  #write(frame: Buffer): void {
    this.sentBytes += frame.length;
    // Messages of one turn, and the ping that follows them, leave in one system call.
    if (this.#connection.writableCorked === 0) {
      this.#connection.cork();
      process.nextTick(() => this.#connection.uncork());
    }
    this.#connection.write(frame);
  }

  #onPong(data: Buffer): void {
    if (this.#pingedBytes === null || data.toString() !== String(this.#pingedBytes)) return;
    this.takenBytes = this.#pingedBytes;
    this.#pingedBytes = null;
    if (this.#mustPingAgain) this.ask();
  }
}
