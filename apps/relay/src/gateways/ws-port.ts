/**
 * A `ws` socket as the smallest socket that the rest of the relay needs. Every message goes through
 * here, so that none, however it came about, can pile up for somebody who does not read. (Pongs have
 * a limit of their own in `ws`.)
 *
 * Messages go to the connection under `ws` as whole frames, in one write each. Pings, pongs and goodbyes, which `ws`
 * writes, keep their place among them: it holds back nothing as long as nothing is compressed.
 *
 * What the other side has taken is found out by pings: its WebSocket library answers each one by
 * itself, after all that came before.
 */
import type { Duplex } from "node:stream";
import { closeReasons } from "@corridor/protocol";
import type { WebSocket } from "ws";
import type { Clock } from "../clock.ts";
import { limits } from "../sessions/limits.ts";
import { textFrame } from "../text-frame.ts";
import type { CarriedSnapshot } from "../sessions/carried-snapshot.ts";
import type { ReaderFlow } from "../sessions/reader-feed.ts";
import { closeWith } from "./conversation.ts";
import type { ReaderLine } from "./reader-line.ts";

/** A class, where a relay holds thousands: an object of closures and getters takes five times the memory. */
export class WsPort implements ReaderLine, ReaderFlow {
  readonly door = "websocket";
  readonly isProof = true;
  sentBytes = 0;
  takenBytes = 0;
  readonly #socket: WebSocket;
  readonly #connection: Duplex;
  readonly #clock: Clock;
  /** what was sent before the ping that is not answered yet */
  #asked: number | null = null;
  #asksAgain = false;

  /**
   * @param connection on which the socket speaks, one whole message after the other, uncompressed
   * @param clock counts the time that a goodbye may take
   */
  constructor(socket: WebSocket, connection: Duplex, clock: Clock) {
    this.#socket = socket;
    this.#connection = connection;
    this.#clock = clock;
    socket.on("pong", (data: Buffer) => this.#answered(data));
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
    if (!this.#mayPass()) return;
    const [frame, ...more] = texts.map(textFrame);
    if (frame !== undefined)
      this.#write(more.length === 0 ? frame : Buffer.concat([frame, ...more]));
  }

  pass({ frame }: CarriedSnapshot): void {
    if (this.#mayPass()) this.#write(frame);
  }

  close(code: number, reason: string): void {
    if (!this.isOpen) return;
    this.#socket.close(code, reason);
    // Who does not read does not answer the goodbye either.
    this.#socket.once(
      "close",
      this.#clock.after(limits.goodbyeMs, () => this.#socket.terminate()),
    );
  }

  ask(): void {
    this.#asksAgain = this.#asked !== null;
    if (this.#asksAgain || !this.isOpen) return;
    this.#asked = this.sentBytes;
    this.#socket.ping(String(this.#asked));
  }

  #mayPass(): boolean {
    if (!this.isOpen) return false;
    if (this.waitingBytes <= limits.stuckReaderBytes) return true;
    closeWith(this, closeReasons.tooSlow);
    return false;
  }

  #write(frame: Buffer): void {
    this.sentBytes += frame.length;
    this.#connection.write(frame);
  }

  #answered(data: Buffer): void {
    if (this.#asked === null || data.toString() !== String(this.#asked)) return;
    this.takenBytes = this.#asked;
    this.#asked = null;
    if (this.#asksAgain) this.ask();
  }
}
