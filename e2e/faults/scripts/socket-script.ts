/** A script that uses the client library, which goes by WebSocket or by its own line over HTTPS. */
import { RobotClient, type RobotClientOptions } from "@corridor/client";
import {
  decodeFrame,
  driverToRelaySchema,
  relayToDriverSchema,
  TTL_MS,
  type CommandRecord,
  type Order,
} from "@corridor/protocol";
import { machineNow } from "../clock.ts";
import { overheard, platformWith } from "../platforms.ts";
import type { Doors } from "../robots/page-messages.ts";
import type { Robot } from "../robots/robot.ts";
import { Diary, type Script } from "./script.ts";

/** Longer than any fault of a row. */
const PATIENCE_MS = 120_000;

export class SocketScript implements Script {
  readonly diary: Diary;
  #client: RobotClient | null = null;
  #newestKey = "";
  heardAt = 0;

  private constructor(robot: Robot, doors: Doors) {
    this.diary = new Diary(robot, doors);
  }

  /** @param origin through which it reaches its relay */
  static async connect(robot: Robot, origin: string, doors: Doors): Promise<SocketScript> {
    const script = new SocketScript(robot, doors);
    const { id, driverKey } = robot.registration;
    const address = `${origin}/r/${id}#${driverKey}`;
    script.#client = await RobotClient.connect(address, script.#options(doors));
    return script;
  }

  post(order: Order): void {
    if (this.#client === null) return;
    const done = send(this.#client, order);
    const key = this.#newestKey;
    // How it ended is compared later; here counts what was never stored.
    done.then(
      (record) => record.key !== key && this.diary.isPassedOver(key),
      () => this.diary.isRefused(key),
    );
  }

  close(): void {
    this.#client?.close();
  }

  #options(doors: Doors): RobotClientOptions {
    const platform = overheard(platformWith(doors), (direction, text) =>
      direction === "up" ? this.#says(text) : this.#hears(text),
    );
    const uniqueText = (): string => {
      this.#newestKey = platform.uniqueText();
      this.diary.asked(this.#newestKey);
      return this.#newestKey;
    };
    return {
      platform: { ...platform, uniqueText },
      answerTimeout: PATIENCE_MS,
      finishTimeout: PATIENCE_MS,
    };
  }

  #says(text: string): void {
    const read = decodeFrame(driverToRelaySchema, text);
    if (!read.ok || read.value.type !== "command") return;
    const { key, sentAt, command } = read.value;
    const isTimed = sentAt !== undefined;
    if (key !== undefined) this.diary.tries(key, command.ttl ?? TTL_MS.default, isTimed);
  }

  #hears(text: string): void {
    const read = decodeFrame(relayToDriverSchema, text);
    if (!read.ok) return;
    if (read.value.type === "welcome") this.heardAt = machineNow();
    if (read.value.type === "ack") this.diary.isAnswered(read.value.record);
    if (read.value.type === "state") this.diary.isTold(read.value.record);
  }
}

/** The method of the library for each action. */
function send(client: RobotClient, { action, ...order }: Order): Promise<CommandRecord> {
  const { ttl = TTL_MS.default, replace = false } = order;
  const wish = { ttl, replace };
  const numbers = order as { distance?: number; degrees?: number } & Partial<
    Record<"left" | "right" | "milliseconds", number>
  >;
  const { distance = 0, degrees = 0, left = 0, right = 0, milliseconds } = numbers;
  switch (action) {
    case "forward":
      return client.forward(wish);
    case "reverse":
      return client.reverse(wish);
    case "stop":
      return client.stop(wish);
    case "left 90":
      return client.left90(wish);
    case "right 90":
      return client.right90(wish);
    case "turn 180":
      return client.turn180(wish);
    case "delayed left 90":
      return client.delayedLeft90(wish);
    case "delayed right 90":
      return client.delayedRight90(wish);
    case "move":
      return client.move(distance, wish);
    case "turn":
      return client.turn(degrees, wish);
    case "drive":
      return client.drive(left, right, milliseconds, wish);
  }
}
