/** A ROS client for tests: a plain WebSocket to the gateway of a robot. */
import type { Socket } from "node:net";
import type { Registration } from "@corridor/protocol";
import { onTestFinished } from "vitest";
import { WebSocket } from "ws";

export interface RosFrame {
  op: string;
  [field: string]: unknown;
}

export interface RosConnectOptions {
  /** in the header */
  key?: string | null;
  /** in the path */
  pathKey?: string;
  headers?: Record<string, string>;
}

export class RosClient {
  readonly #socket: WebSocket;
  readonly #inbox: RosFrame[] = [];
  #wake: () => void = () => undefined;
  #connection: Socket | null = null;
  readonly closed: Promise<{ code: number; reason: string }>;

  private constructor(socket: WebSocket) {
    this.#socket = socket;
    socket.on("upgrade", ({ socket: connection }) => (this.#connection = connection));
    socket.on("message", (data: Buffer) => {
      this.#inbox.push(JSON.parse(data.toString()) as RosFrame);
      this.#wake();
    });
    this.closed = new Promise((resolve) => {
      socket.on("close", (code, reason) => {
        resolve({ code, reason: reason.toString() });
        this.#wake();
      });
    });
    onTestFinished(() => socket.terminate());
  }

  /** Connects, with the driver key unless another one, or none, is given. */
  static async connect(
    { origin }: { origin: string },
    { id, driverKey }: Registration,
    options: RosConnectOptions = {},
  ): Promise<RosClient> {
    const { key = driverKey, pathKey } = options;
    const isInHeader = pathKey === undefined && key !== null;
    const path = pathKey === undefined ? "" : `/${pathKey}`;
    const headers = { ...(isInHeader && { Authorization: `Bearer ${key}` }), ...options.headers };
    return RosClient.open(`${origin.replace("http", "ws")}/r/${id}/ros${path}`, headers);
  }

  /** Connects to any rosbridge. */
  static async open(url: string, headers: Record<string, string> = {}): Promise<RosClient> {
    const socket = new WebSocket(url, { headers });
    const client = new RosClient(socket);
    await new Promise((resolve, reject) => {
      socket.once("open", resolve);
      socket.once("error", reject);
    });
    return client;
  }

  /** @returns the status of the response that refuses the connection */
  static async refusedWith(...connecting: Parameters<typeof RosClient.connect>): Promise<number> {
    const error: unknown = await RosClient.connect(...connecting).catch(
      (reason: unknown) => reason,
    );
    const [, status] = /Unexpected server response: (\d+)/.exec(String(error)) ?? [];
    return Number(status);
  }

  send(message: object): void {
    this.#socket.send(JSON.stringify(message));
  }

  sendText(text: string | Uint8Array, isBinary = false): void {
    this.#socket.send(text, { binary: isBinary });
  }

  /** The next frame with this value of a field. Discards earlier ones. */
  async next(field: "op" | "id" | "topic", value: string): Promise<RosFrame> {
    for (;;) {
      const frame = this.#inbox.shift();
      if (frame?.[field] === value) return frame;
      if (frame !== undefined) continue;
      if (this.#socket.readyState === WebSocket.CLOSED) {
        throw new Error(`The connection was closed before ${field} ${value} came.`);
      }
      await new Promise<void>((resolve) => (this.#wake = resolve));
    }
  }

  /** Calls a service. @returns its response */
  async call(service: string, args?: unknown): Promise<RosFrame> {
    this.send({ op: "call_service", id: service, service, args });
    return this.next("id", service);
  }

  /** Ends the outgoing direction of the TCP connection only. */
  halfClose(): void {
    this.#connection?.end();
  }

  close(): void {
    this.#socket.close();
  }
}
