/**
 * A script like robot libraries that are not written for this service: it publishes without waiting
 * for answers, queues messages while disconnected, and sends the whole queue after a reconnect.
 */
import {
  decodeFrame,
  encodeFrame,
  PROTOCOL_VERSION,
  relayToDriverSchema,
  TTL_MS,
  type Order,
} from "@corridor/protocol";
import { randomUUID } from "node:crypto";
import { machineNow } from "../clock.ts";
import type { Robot } from "../robots/robot.ts";
import { CommandLog, type Script } from "./script.ts";

const RETRY_MS = 100;

export class FlushingScript implements Script {
  readonly commands: CommandLog;
  readonly #url: string;
  readonly #hello: string;
  #queue: string[] = [];
  #socket: WebSocket | null = null;
  #isClosed = false;
  lastResponseAt = 0;

  /** @param origin the address at which it reaches its relay */
  constructor(robot: Robot, origin: string) {
    this.commands = new CommandLog(robot, "flushing");
    const { id, driverKey: key } = robot.registration;
    this.#url = `${origin.replace("http", "ws")}/api/v1/robots/${id}/socket`;
    this.#hello = encodeFrame({ type: "hello", version: PROTOCOL_VERSION, role: "drive", key });
    this.#connect();
  }

  post(order: Order): void {
    const key = randomUUID();
    this.commands.recordRequest(key);
    this.commands.recordAttempt(key, order.ttl ?? TTL_MS.default);
    this.#queue.push(encodeFrame({ type: "command", key, command: order }));
    this.#flush();
  }

  close(): void {
    this.#isClosed = true;
    this.#socket?.close();
  }

  #connect(): void {
    if (this.#isClosed) return;
    const socket = new WebSocket(this.#url);
    socket.onopen = () => socket.send(this.#hello);
    socket.onmessage = ({ data }) => {
      const read = decodeFrame(relayToDriverSchema, String(data));
      if (!read.ok) return;
      const message = read.value;
      if (message.type === "ack") this.commands.recordAck(message.record);
      if (message.type === "state") this.commands.recordState(message.record);
      if (message.type === "problem" && message.key !== null)
        this.commands.recordRejection(message.key);
      if (message.type !== "welcome") return;
      this.lastResponseAt = machineNow();
      this.#socket = socket;
      this.#flush();
    };
    socket.onclose = () => {
      this.#socket = null;
      setTimeout(() => this.#connect(), RETRY_MS);
    };
  }

  #flush(): void {
    if (this.#socket?.readyState !== WebSocket.OPEN) return;
    for (const text of this.#queue) this.#socket.send(text);
    this.#queue = [];
  }
}
