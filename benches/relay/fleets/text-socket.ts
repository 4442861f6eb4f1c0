/** A minimal WebSocket client for text messages. Errors abort the benchmark. */
import { connect, type Socket } from "node:net";
import { CLOSE, decodeFrames, encodeFrame, PING, PONG, TEXT, type Frame } from "./frames.ts";

export interface TextSocketOptions {
  port: number;
  path: string;
  headers: Record<string, string>;
  onMessage: (text: string) => void;
}

export class TextSocket {
  readonly #socket: Socket;
  readonly #onMessage: (text: string) => void;
  #isClosed = false;

  private constructor(socket: Socket, onMessage: (text: string) => void) {
    this.#socket = socket;
    this.#onMessage = onMessage;
  }

  static async open({ port, path, headers, onMessage }: TextSocketOptions): Promise<TextSocket> {
    const socket = connect({ port, host: "127.0.0.1", noDelay: true });
    const textSocket = new TextSocket(socket, onMessage);
    const headerFields = {
      Host: `127.0.0.1:${port}`,
      Connection: "Upgrade",
      Upgrade: "websocket",
      "Sec-WebSocket-Version": "13",
      "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==",
      ...headers,
    };
    const lines = Object.entries(headerFields).map(([name, value]) => `${name}: ${value}`);
    socket.write(`GET ${path} HTTP/1.1\r\n${lines.join("\r\n")}\r\n\r\n`);
    await new Promise<void>((resolve, reject) => {
      socket.once("error", reject);
      let bytes: Buffer = Buffer.alloc(0);
      let isOpen = false;
      socket.on("data", (data: Buffer) => {
        bytes = bytes.length === 0 ? data : Buffer.concat([bytes, data]);
        if (!isOpen) {
          const end = bytes.indexOf("\r\n\r\n");
          if (end < 0) return;
          const answer = bytes.toString("latin1", 0, end);
          if (!answer.startsWith("HTTP/1.1 101")) return reject(new Error(answer));
          isOpen = true;
          bytes = bytes.subarray(end + 4);
          resolve();
        }
        bytes = decodeFrames(bytes, (frame) => textSocket.#onFrame(frame));
      });
    });
    socket.on("close", () => textSocket.#fail("a connection was closed"));
    return textSocket;
  }

  send(text: string): void {
    this.#socket.write(encodeFrame(TEXT, Buffer.from(text)));
  }

  close(): void {
    this.#isClosed = true;
    this.#socket.destroy();
  }

  #onFrame({ opcode, payload }: Frame): void {
    if (opcode === TEXT) this.#onMessage(payload.toString("latin1"));
    else if (opcode === PING) this.#socket.write(encodeFrame(PONG, payload));
    else if (opcode === CLOSE) {
      this.#fail(`closed with ${payload.readUInt16BE(0)}: ${payload.subarray(2).toString()}`);
    }
  }

  #fail(reason: string): void {
    if (!this.#isClosed) throw new Error(reason);
  }
}
