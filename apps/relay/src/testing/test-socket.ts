/** A minimal WebSocket client that sends and receives single messages of a page or a script. */
import type { Duplex } from "node:stream";
import type { Registration } from "@corridor/protocol";
import { onTestFinished } from "vitest";
import { WebSocket } from "ws";
import type { Requests } from "./test-relay.ts";

export interface Message {
  type: string;
  [field: string]: unknown;
}

export class TestSocket {
  readonly #socket: WebSocket;
  readonly #inbox: Message[] = [];
  #connection: Duplex | null = null;
  #wake: () => void = () => undefined;
  /** number of pings of the relay */
  pings = 0;
  /** close code and reason */
  readonly closed: Promise<{ code: number; reason: string }>;

  private constructor(socket: WebSocket) {
    this.#socket = socket;
    socket.on("message", (data: Buffer) => {
      this.#inbox.push(JSON.parse(data.toString()) as Message);
      this.#wake();
    });
    this.closed = new Promise((resolve) => {
      socket.on("close", (code, reason) => {
        resolve({ code, reason: reason.toString() });
        this.#wake();
      });
    });
    socket.on("ping", () => (this.pings += 1));
    socket.on("upgrade", ({ socket: line }) => (this.#connection = line));
    onTestFinished(() => socket.terminate());
  }

  static async open(
    relay: Requests,
    id: string,
    headers: Record<string, string> = {},
    options: { autoPong?: boolean } = {},
  ): Promise<TestSocket> {
    return TestSocket.at(relay, `/robots/${id}/socket`, { headers, ...options });
  }

  /** Opens the socket at a path of the API. */
  static async at(
    { origin }: { origin: string },
    path: string,
    options: { headers?: Record<string, string>; autoPong?: boolean } = {},
  ): Promise<TestSocket> {
    const socket = new WebSocket(`${origin.replace("http", "ws")}/api/v1${path}`, options);
    const test = new TestSocket(socket);
    await new Promise((resolve, reject) => {
      socket.once("open", resolve);
      socket.once("error", reject);
    });
    return test;
  }

  /** Connects as the robot's page and waits for the welcome. */
  static async page(
    relay: Requests,
    robot: Registration,
    resume: Record<string, unknown> = {},
  ): Promise<{ socket: TestSocket; epoch: number }> {
    const socket = await TestSocket.open(relay, robot.id);
    socket.send({ type: "hello", version: 1, role: "own", key: robot.ownerKey });
    socket.send({ type: "resume", lastApplied: 0, fresh: false, endings: [], ...resume });
    const welcome = await socket.next("welcome");
    return { socket, epoch: Number(welcome["epoch"]) };
  }

  /** Connects as a script and waits for the welcome. */
  static async driver(relay: Requests, robot: Registration): Promise<TestSocket> {
    const socket = await TestSocket.open(relay, robot.id, { "User-Agent": "Python-urllib/3.11" });
    socket.send({ type: "hello", version: 1, role: "drive", key: robot.driverKey });
    await socket.next("welcome");
    return socket;
  }

  send(message: unknown): void {
    this.#socket.send(JSON.stringify(message));
  }

  sendRaw(data: string | Uint8Array): void {
    this.#socket.send(data);
  }

  /** Sends bytes in a text frame. */
  sendText(bytes: Uint8Array): void {
    this.#socket.send(bytes, { binary: false });
  }

  /** Half-closes the TCP connection without a close frame. */
  halfClose(): void {
    this.#connection?.end();
  }

  /** Returns the next message of one of these types and discards earlier ones. */
  async next(...types: string[]): Promise<Message> {
    for (;;) {
      const message = this.#inbox.shift();
      if (message !== undefined && types.includes(message.type)) return message;
      if (message !== undefined) continue;
      if (this.#socket.readyState === WebSocket.CLOSED) {
        throw new Error(`The socket was closed before a ${types.join(" or ")} came.`);
      }
      await new Promise<void>((resolve) => (this.#wake = resolve));
    }
  }

  /** Stops reading, so that the relay's messages are buffered. */
  pause(): void {
    this.#socket.pause();
  }

  resume(): void {
    this.#socket.resume();
  }

  close(): void {
    this.#socket.close();
  }
}
