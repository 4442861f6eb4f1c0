/** A script that uses the client library, by WebSocket or by the library's long-poll connection. */
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
import { withListener, platformFor } from "../platforms.ts";
import type { Transports } from "../robots/page-messages.ts";
import type { Robot } from "../robots/robot.ts";
import { CommandLog, type Script } from "./script.ts";

/** longer than any fault of a scenario */
const TIMEOUT_MS = 120_000;

export class ClientScript implements Script {
  readonly commands: CommandLog;
  #client: RobotClient | null = null;
  #newestKey = "";
  lastResponseAt = 0;

  private constructor(robot: Robot, transports: Transports) {
    this.commands = new CommandLog(robot, transports);
  }

  /** @param origin the address at which it reaches its relay */
  static async connect(
    robot: Robot,
    origin: string,
    transports: Transports,
  ): Promise<ClientScript> {
    const script = new ClientScript(robot, transports);
    const { id, driverKey } = robot.registration;
    const address = `${origin}/r/${id}#${driverKey}`;
    script.#client = await RobotClient.connect(address, script.#options(transports));
    return script;
  }

  post(order: Order): void {
    if (this.#client === null) return;
    const done = send(this.#client, order);
    const key = this.#newestKey;
    // Endings are compared later. This records only commands that were never stored.
    done.then(
      (record) => record.key !== key && this.commands.recordSuperseded(key),
      () => this.commands.recordRejection(key),
    );
  }

  close(): void {
    this.#client?.close();
  }

  #options(transports: Transports): RobotClientOptions {
    const platform = withListener(platformFor(transports), (direction, text) =>
      direction === "up" ? this.#onSent(text) : this.#onReceived(text),
    );
    const uniqueText = (): string => {
      this.#newestKey = platform.uniqueText();
      this.commands.recordRequest(this.#newestKey);
      return this.#newestKey;
    };
    return {
      platform: { ...platform, uniqueText },
      answerTimeout: TIMEOUT_MS,
      finishTimeout: TIMEOUT_MS,
    };
  }

  #onSent(text: string): void {
    const read = decodeFrame(driverToRelaySchema, text);
    if (!read.ok || read.value.type !== "command") return;
    const { key, sentAt, command } = read.value;
    const isTimed = sentAt !== undefined;
    if (key !== undefined) this.commands.recordAttempt(key, command.ttl ?? TTL_MS.default, isTimed);
  }

  #onReceived(text: string): void {
    const read = decodeFrame(relayToDriverSchema, text);
    if (!read.ok) return;
    if (read.value.type === "welcome") this.lastResponseAt = machineNow();
    if (read.value.type === "ack") this.commands.recordAck(read.value.record);
    if (read.value.type === "state") this.commands.recordState(read.value.record);
  }
}

/** Calls the library method of each action. */
function send(client: RobotClient, { action, ...order }: Order): Promise<CommandRecord> {
  const { ttl = TTL_MS.default, replace = false } = order;
  const options = { ttl, replace };
  const numbers = order as { distance?: number; degrees?: number } & Partial<
    Record<"left" | "right" | "milliseconds", number>
  >;
  const { distance = 0, degrees = 0, left = 0, right = 0, milliseconds } = numbers;
  switch (action) {
    case "forward":
      return client.forward(options);
    case "reverse":
      return client.reverse(options);
    case "stop":
      return client.stop(options);
    case "reset":
      return client.reset(options);
    case "left 90":
      return client.left90(options);
    case "right 90":
      return client.right90(options);
    case "turn 180":
      return client.turn180(options);
    case "delayed left 90":
      return client.delayedLeft90(options);
    case "delayed right 90":
      return client.delayedRight90(options);
    case "move":
      return client.move(distance, options);
    case "turn":
      return client.turn(degrees, options);
    case "drive":
      return client.drive(left, right, milliseconds, options);
  }
}
