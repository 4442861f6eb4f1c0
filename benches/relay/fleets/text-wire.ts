/** The smallest WebSocket client that can carry texts. Whatever goes wrong ends the measurement. */
import { connect, type Socket } from "node:net";
import { CLOSE, frameOf, PING, PONG, takeFrames, TEXT, type Frame } from "./frames.ts";

export interface WireOptions {
  port: number;
  path: string;
  headers: Record<string, string>;
  hear: (text: string) => void;
}

export class TextWire {
  readonly #socket: Socket;
  readonly #hear: (text: string) => void;
  #isClosed = false;

  private constructor(socket: Socket, hear: (text: string) => void) {
    this.#socket = socket;
    this.#hear = hear;
  }

  static async open({ port, path, headers, hear }: WireOptions): Promise<TextWire> {
    const socket = connect({ port, host: "127.0.0.1", noDelay: true });
    const wire = new TextWire(socket, hear);
    const words = {
      Host: `127.0.0.1:${port}`,
      Connection: "Upgrade",
      Upgrade: "websocket",
      "Sec-WebSocket-Version": "13",
      "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==",
      ...headers,
    };
    const lines = Object.entries(words).map(([name, value]) => `${name}: ${value}`);
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
        bytes = takeFrames(bytes, (frame) => wire.#take(frame));
      });
    });
    socket.on("close", () => wire.#lost("a connection was cut"));
    return wire;
  }

  send(text: string): void {
    this.#socket.write(frameOf(TEXT, Buffer.from(text)));
  }

  close(): void {
    this.#isClosed = true;
    this.#socket.destroy();
  }

  #take({ opcode, payload }: Frame): void {
    if (opcode === TEXT) this.#hear(payload.toString("latin1"));
    else if (opcode === PING) this.#socket.write(frameOf(PONG, payload));
    else if (opcode === CLOSE) {
      this.#lost(`closed with ${payload.readUInt16BE(0)}: ${payload.subarray(2).toString()}`);
    }
  }

  #lost(words: string): void {
    if (!this.#isClosed) throw new Error(words);
  }
}
