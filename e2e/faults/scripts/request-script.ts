/**
 * A script of plain HTTPS requests without a library. It sends one command after the other, and
 * repeats each with its key and its age until it is answered.
 */
import { commandRecordSchema, readJson, TTL_MS, type Order } from "@corridor/protocol";
import { randomUUID } from "node:crypto";
import { machineNow, sleep } from "../clock.ts";
import type { Robot } from "../robots/robot.ts";
import { CommandLog, type Script } from "./script.ts";

const RETRY_MS = 100;
const RESPONSE_TIMEOUT_MS = 5_000;
const MAX_RESPONSE = 64 * 1024;

interface QueuedCommand {
  key: string;
  order: Order;
}

export class RequestScript implements Script {
  readonly commands: CommandLog;
  readonly #url: string;
  readonly #key: string;
  #queue: QueuedCommand[] = [];
  #isSending = false;
  #isClosed = false;
  lastResponseAt = 0;

  /** @param origin the address at which it reaches its relay */
  constructor(robot: Robot, origin: string) {
    this.commands = new CommandLog(robot, "request");
    const { id, driverKey } = robot.registration;
    this.#url = `${origin}/api/v1/robots/${id}/commands`;
    this.#key = driverKey;
  }

  post(order: Order): void {
    const key = randomUUID();
    this.commands.recordRequest(key);
    const last = this.#queue.at(-1);
    if (last !== undefined && isVelocity(last.order) && isVelocity(order)) {
      this.#queue.pop();
      this.commands.recordSuperseded(last.key);
    }
    this.#queue.push({ key, order });
    void this.#send();
  }

  close(): void {
    this.#isClosed = true;
    this.#queue = [];
  }

  async #send(): Promise<void> {
    if (this.#isSending) return;
    this.#isSending = true;
    for (let next = this.#queue.shift(); next !== undefined; next = this.#queue.shift()) {
      await this.#sendUntilAnswered(next);
    }
    this.#isSending = false;
  }

  async #sendUntilAnswered({ key, order }: QueuedCommand): Promise<void> {
    const firstTry = machineNow();
    while (!this.#isClosed) {
      this.commands.recordAttempt(key, order.ttl ?? TTL_MS.default);
      const age = Math.round(machineNow() - firstTry);
      const isOver = await this.#try(key, { ...order, age }).catch(() => false);
      if (isOver || this.#isSuperseded({ key, order })) return;
      await sleep(RETRY_MS);
    }
  }

  /** Whether a newer velocity is queued, so that this one need not be retried. */
  #isSuperseded({ key, order }: QueuedCommand): boolean {
    const [next] = this.#queue;
    if (next === undefined || !isVelocity(order) || !isVelocity(next.order)) return false;
    this.commands.recordSuperseded(key);
    return true;
  }

  /** @returns whether the answer is final */
  async #try(key: string, order: Order): Promise<boolean> {
    const answer = await fetch(this.#url, {
      method: "POST",
      headers: {
        Authorization: `Bearer ${this.#key}`,
        "Content-Type": "application/json",
        "Idempotency-Key": key,
      },
      body: JSON.stringify(order),
      signal: AbortSignal.timeout(RESPONSE_TIMEOUT_MS),
    });
    const text = await answer.text();
    this.lastResponseAt = machineNow();
    const record = readJson(commandRecordSchema, text, MAX_RESPONSE);
    if (answer.ok && record.ok) {
      this.commands.recordAck(record.value);
      return true;
    }
    if (answer.status === 429 || answer.status >= 500) return false;
    this.commands.recordRejection(key);
    return true;
  }
}

/**
 * A velocity without a duration. Only the newest queued velocity is sent, as it replaces the
 * others.
 */
function isVelocity(order: Order): boolean {
  return order.action === "drive" && order.milliseconds === undefined && order.replace !== true;
}
