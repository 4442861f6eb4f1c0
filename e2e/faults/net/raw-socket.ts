/** A WebSocket byte by byte, for what no client library would send. */
import { randomBytes } from "node:crypto";
import { once } from "node:events";
import { connect, type Socket } from "node:net";

export interface Frame {
  payload: Buffer;
  /** 1 text, 2 binary, 8 close, 9 ping; 3 to 7 mean nothing */
  opcode?: number;
  /** clients have to mask what they send */
  isMasked?: boolean;
  isLast?: boolean;
  /** bits that no extension has given a meaning, 1 to 7 */
  reserved?: number;
  /** what the frame says of its length; default: the truth */
  length?: number;
}

const KEPT_BYTES = 100_000;

export class RawSocket {
  readonly #socket: Socket;
  #answer = "";
  /** how many bytes came so far */
  received = 0;

  private constructor(socket: Socket) {
    this.#socket = socket;
    socket.on("data", (data: Buffer) => {
      this.received += data.length;
      if (this.#answer.length < KEPT_BYTES) this.#answer += data.toString("latin1");
    });
    socket.on("error", () => undefined);
  }

  /** Opens one at a path and waits for the upgrade. */
  static async open(origin: string, path: string): Promise<RawSocket> {
    const { hostname, port } = new URL(origin);
    const raw = new RawSocket(connect(Number(port), hostname));
    await once(raw.#socket, "connect");
    raw.write(
      `GET ${path} HTTP/1.1\r\nHost: ${hostname}:${port}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n` +
        `Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: ${randomBytes(16).toString("base64")}\r\n\r\n`,
    );
    await once(raw.#socket, "data");
    return raw;
  }

  /** what came at first, byte for byte */
  get answer(): string {
    return this.#answer;
  }

  get isOpen(): boolean {
    return !this.#socket.destroyed && this.#socket.readable;
  }

  text(text: string): void {
    this.frame({ payload: Buffer.from(text) });
  }

  frame(frame: Frame): void {
    this.write(bytesOf(frame));
  }

  write(bytes: string | Uint8Array): void {
    if (this.#socket.writable) this.#socket.write(bytes);
  }

  /** Reads nothing, as a program that sleeps. */
  sleep(): void {
    this.#socket.pause();
  }

  wake(): void {
    this.#socket.resume();
  }

  /** Says that nothing more comes, and listens on. */
  halfClose(): void {
    this.#socket.end();
  }

  destroy(): void {
    this.#socket.destroy();
  }
}

function bytesOf({
  payload,
  opcode = 1,
  isMasked = true,
  isLast = true,
  reserved = 0,
  length = payload.length,
}: Frame): Buffer {
  const mask = isMasked ? 0x80 : 0;
  const head = [(isLast ? 0x80 : 0) | (reserved << 4) | opcode];
  if (length < 126) head.push(mask | length);
  else if (length < 65_536) head.push(mask | 126, length >> 8, length & 255);
  else
    head.push(mask | 127, 0, 0, 0, 0, ...[24, 16, 8, 0].map((shift) => (length >>> shift) & 255));
  if (!isMasked) return Buffer.concat([Buffer.from(head), payload]);
  const key = randomBytes(4);
  const masked = payload.map((byte, at) => byte ^ (key[at % 4] ?? 0));
  return Buffer.concat([Buffer.from(head), key, masked]);
}
