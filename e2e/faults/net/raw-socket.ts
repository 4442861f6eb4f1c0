/** A WebSocket at byte level, for frames that no client library sends. */
import { randomBytes } from "node:crypto";
import { once } from "node:events";
import { connect, type Socket } from "node:net";

export interface Frame {
  payload: Buffer;
  /** 1 text, 2 binary, 8 close, 9 ping; 3 to 7 are reserved */
  opcode?: number;
  /** clients must mask their frames */
  isMasked?: boolean;
  isLast?: boolean;
  /** reserved bits (RSV), 1 to 7 */
  reserved?: number;
  /** length field of the frame; default: the real length */
  length?: number;
}

const MAX_STORED_BYTES = 100_000;

export class RawSocket {
  readonly #socket: Socket;
  #response = "";
  /** number of bytes received so far */
  received = 0;

  private constructor(socket: Socket) {
    this.#socket = socket;
    socket.on("data", (data: Buffer) => {
      this.received += data.length;
      if (this.#response.length < MAX_STORED_BYTES) this.#response += data.toString("latin1");
    });
    socket.on("error", () => undefined);
  }

  /** Opens a WebSocket at a path and waits for the upgrade response. */
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

  /** the first bytes received */
  get response(): string {
    return this.#response;
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

  /** Stops reading, as a suspended program does. */
  pause(): void {
    this.#socket.pause();
  }

  resume(): void {
    this.#socket.resume();
  }

  /** Closes the sending side and continues to receive. */
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
