/**
 * A script of plain HTTPS requests, as somebody writes it who has no library: one command after the
 * other, each posted again with its key and its age until it is answered.
 */
import { commandRecordSchema, readJson, TTL_MS, type Order } from "@corridor/protocol";
import { randomUUID } from "node:crypto";
import { machineNow, sleep } from "../clock.ts";
import type { Robot } from "../robots/robot.ts";
import { Diary, type Script } from "./script.ts";

const AGAIN_MS = 100;
const ANSWER_MS = 5_000;
const MAX_ANSWER = 64 * 1024;

interface Wish {
  key: string;
  order: Order;
}

export class RequestScript implements Script {
  readonly diary: Diary;
  readonly #url: string;
  readonly #key: string;
  #waiting: Wish[] = [];
  #isSending = false;
  #isClosed = false;
  heardAt = 0;

  /** @param origin through which it reaches its relay */
  constructor(robot: Robot, origin: string) {
    this.diary = new Diary(robot, "request");
    const { id, driverKey } = robot.registration;
    this.#url = `${origin}/api/v1/robots/${id}/commands`;
    this.#key = driverKey;
  }

  post(order: Order): void {
    const key = randomUUID();
    this.diary.asked(key);
    const last = this.#waiting.at(-1);
    if (last !== undefined && isVelocity(last.order) && isVelocity(order)) {
      this.#waiting.pop();
      this.diary.isPassedOver(last.key);
    }
    this.#waiting.push({ key, order });
    void this.#send();
  }

  close(): void {
    this.#isClosed = true;
    this.#waiting = [];
  }

  async #send(): Promise<void> {
    if (this.#isSending) return;
    this.#isSending = true;
    for (let next = this.#waiting.shift(); next !== undefined; next = this.#waiting.shift()) {
      await this.#untilAnswered(next);
    }
    this.#isSending = false;
  }

  async #untilAnswered({ key, order }: Wish): Promise<void> {
    const firstTry = machineNow();
    while (!this.#isClosed) {
      this.diary.tries(key, order.ttl ?? TTL_MS.default);
      const age = Math.round(machineNow() - firstTry);
      const isOver = await this.#try(key, { ...order, age }).catch(() => false);
      if (isOver || this.#isPassedOver({ key, order })) return;
      await sleep(AGAIN_MS);
    }
  }

  /** Whether a newer velocity waits, and this one need not be tried again. */
  #isPassedOver({ key, order }: Wish): boolean {
    const [next] = this.#waiting;
    if (next === undefined || !isVelocity(order) || !isVelocity(next.order)) return false;
    this.diary.isPassedOver(key);
    return true;
  }

  /** @returns whether there is an answer that holds */
  async #try(key: string, order: Order): Promise<boolean> {
    const answer = await fetch(this.#url, {
      method: "POST",
      headers: {
        Authorization: `Bearer ${this.#key}`,
        "Content-Type": "application/json",
        "Idempotency-Key": key,
      },
      body: JSON.stringify(order),
      signal: AbortSignal.timeout(ANSWER_MS),
    });
    const text = await answer.text();
    this.heardAt = machineNow();
    const record = readJson(commandRecordSchema, text, MAX_ANSWER);
    if (answer.ok && record.ok) {
      this.diary.isAnswered(record.value);
      return true;
    }
    if (answer.status === 429 || answer.status >= 500) return false;
    this.diary.isRefused(key);
    return true;
  }
}

/** Of those that wait only the newest is sent: a drive without a time says what holds now. */
function isVelocity(order: Order): boolean {
  return order.action === "drive" && order.milliseconds === undefined && order.replace !== true;
}
