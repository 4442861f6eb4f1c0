/**
 * A script as robot libraries have it that know nothing of this service: it publishes without
 * waiting for answers, keeps what it cannot send while its line is down, and sends all of it once
 * the line is back.
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
import { Diary, type Script } from "./script.ts";

const AGAIN_MS = 100;

export class FlushingScript implements Script {
  readonly diary: Diary;
  readonly #url: string;
  readonly #hello: string;
  #kept: string[] = [];
  #socket: WebSocket | null = null;
  #isClosed = false;
  heardAt = 0;

  /** @param origin through which it reaches its relay */
  constructor(robot: Robot, origin: string) {
    this.diary = new Diary(robot, "flushing");
    const { id, driverKey: key } = robot.registration;
    this.#url = `${origin.replace("http", "ws")}/api/v1/robots/${id}/socket`;
    this.#hello = encodeFrame({ type: "hello", version: PROTOCOL_VERSION, role: "drive", key });
    this.#connect();
  }

  post(order: Order): void {
    const key = randomUUID();
    this.diary.asked(key);
    this.diary.tries(key, order.ttl ?? TTL_MS.default);
    this.#kept.push(encodeFrame({ type: "command", key, command: order }));
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
      if (message.type === "ack") this.diary.isAnswered(message.record);
      if (message.type === "state") this.diary.isTold(message.record);
      if (message.type === "problem" && message.key !== null) this.diary.isRefused(message.key);
      if (message.type !== "welcome") return;
      this.heardAt = machineNow();
      this.#socket = socket;
      this.#flush();
    };
    socket.onclose = () => {
      this.#socket = null;
      setTimeout(() => this.#connect(), AGAIN_MS);
    };
  }

  #flush(): void {
    if (this.#socket?.readyState !== WebSocket.OPEN) return;
    for (const text of this.#kept) this.#socket.send(text);
    this.#kept = [];
  }
}
