import {
  describeProblem,
  MAX_SENT_NAME,
  orderSchema,
  readValue,
  type CommandRecord,
  type Order,
  type RobotAddress,
  type SensorReadings,
  type Snapshot,
} from "@corridor/protocol";
import { ClientError, withCallSite } from "./client-error.ts";
import { clientParts } from "./client-parts.ts";
import { isWatchKey, watchLinkError } from "./close-error.ts";
import { wrongOptions, type CommandName } from "./command-options.ts";
import type { Until } from "./command-queue.ts";
import { DriverConnection } from "./driver-connection.ts";
import type { RobotEvent } from "./event-inbox.ts";
import { pairRobot } from "./pairing.ts";
import { globalPlatform } from "./platform.ts";
import { parseRobotAddress } from "./robot-address.ts";
import type {
  CommandOptions,
  DriveOptions,
  MotionOptions,
  RobotClientOptions,
} from "./robot-client-options.ts";
import { readMaze, type RobotMaze } from "./robot-maze.ts";

const DEFAULT_RESPONSE_MS = 30_000;
const DEFAULT_FINISH_MS = 600_000;

/**
 * A robot on the network, simulated or physical.
 *
 * Commands are sent one at a time, in order. Their methods resolve with the record of the command:
 * for a manoeuvre when the robot has finished it, for an endless motion when the robot has started
 * it. The states `completed` and `collided` (the robot met a wall) are not errors.
 *
 * They reject with a `ClientError`: `bad-command` if a number is out of range, `refused` if the
 * relay refused the command, `cancelled`, `superseded` or `expired` if it ended early, `timeout` if
 * the relay or the robot took too long, and `closed`.
 *
 * After a reconnect the client sends a command again with its idempotency key and its age, so that
 * the robot never executes it twice or late.
 */
export class RobotClient {
  /** the whole address with its key, to connect again. Keep it private */
  readonly address: string;
  readonly #robot: RobotAddress;
  readonly #connection: DriverConnection;
  readonly #defaults: CommandOptions;

  /** @param options always given by this class; missing if JavaScript calls the constructor */
  private constructor(address: string, options?: RobotClientOptions) {
    if (options === undefined) {
      const usage = "Use: await RobotClient.connect(address).";
      throw new ClientError("bad-command", "new RobotClient() does not connect", usage);
    }
    this.#robot = parseRobotAddress(address);
    const { origin, id, key } = this.#robot;
    this.address = `${origin}/r/${id}#${key}`;
    this.#defaults = options.ttl === undefined ? {} : { ttl: options.ttl };
    this.#connection = new DriverConnection(this.#robot, {
      platform: options.platform ?? globalPlatform(),
      responseMs: options.answerTimeout ?? DEFAULT_RESPONSE_MS,
      finishMs: options.finishTimeout ?? DEFAULT_FINISH_MS,
      name: options.name?.slice(0, MAX_SENT_NAME),
    });
    clientParts.set(this, this.#connection);
  }

  /**
   * Connects to a robot.
   * @param address `http://HOST/r/ID#KEY`, as the robot's page shows it under Remote
   * @param options timeouts and a name
   * @returns the robot, once the relay has accepted the key
   * @throws ClientError bad-address, not-authorised, blocked, no-robot or timeout
   */
  static connect(address: string, options: RobotClientOptions = {}): Promise<RobotClient> {
    return withCallSite(RobotClient, "connect", async () => {
      const robot = new RobotClient(address, options);
      await robot.#connection.open();
      return robot;
    });
  }

  /**
   * Connects by a pairing code, and waits until the robot's owner accepts this script. Use
   * `address` of the robot to connect again without a code.
   * @param service the origin of the robot's page, such as `http://HOST`
   * @param code the 8 letters that the page shows under Remote; spaces and lower case are accepted
   * @param options timeouts and a name, which the owner sees
   * @returns the robot, once it is connected
   * @throws ClientError wrong-code, pairing-refused, pairing-over, too-many-tries, or as `connect`
   */
  static pair(
    service: string,
    code: string,
    options: RobotClientOptions = {},
  ): Promise<RobotClient> {
    const { platform = globalPlatform(), answerTimeout = DEFAULT_RESPONSE_MS, name } = options;
    const request = { service, code, name: name?.slice(0, MAX_SENT_NAME) ?? null };
    return withCallSite(RobotClient, "pair", async () => {
      const address = await pairRobot(platform, request, answerTimeout);
      return RobotClient.connect(address, { ...options, platform });
    });
  }

  /**
   * Drives forward until the next command, or until a condition is true. The robot stops within 3 s
   * after this client was closed.
   * @param options options of this command
   * @returns the record, once the robot has started; with `until`, once it has finished
   */
  forward(options: MotionOptions = {}): Promise<CommandRecord> {
    return this.#move("forward", { action: "forward" }, options);
  }

  /**
   * Drives backward until the next command or a condition, as `forward` does.
   * @param options options of this command
   * @returns the record, once the robot has started; with `until`, once it has finished
   */
  reverse(options: MotionOptions = {}): Promise<CommandRecord> {
    return this.#move("reverse", { action: "reverse" }, options);
  }

  /**
   * Stops at once: cancels the running command and all waiting ones, from every script.
   * @param options options of this command; the default `ttl` is always 10 s
   * @returns the record, once the robot has stopped
   */
  stop(options: CommandOptions = {}): Promise<CommandRecord> {
    return this.#do("stop", { action: "stop" }, options, "ended");
  }

  /**
   * Puts the robot at its start, which begins a new run. Ends all earlier commands, from every script,
   * as `superseded`. A robot accepts one reset a second; the client waits for its turn.
   *
   * It rejects with `refused` if the robot's owner has forbidden it, or if the robot cannot do it,
   * such as a physical robot: `catch` the error to continue from where the robot is.
   * @param options options of this command
   * @returns the record, once the robot is at its start
   */
  reset(options: CommandOptions = {}): Promise<CommandRecord> {
    return this.#do("reset", { action: "reset" }, options, "ended");
  }

  /**
   * Turns left by 90 degrees on the spot.
   * @param options options of this command
   * @returns the record, once the robot has finished
   */
  left90(options: CommandOptions = {}): Promise<CommandRecord> {
    return this.#do("left90", { action: "left 90" }, options, "ended");
  }

  /**
   * Turns right by 90 degrees on the spot.
   * @param options options of this command
   * @returns the record, once the robot has finished
   */
  right90(options: CommandOptions = {}): Promise<CommandRecord> {
    return this.#do("right90", { action: "right 90" }, options, "ended");
  }

  /**
   * Turns by 180 degrees on the spot.
   * @param options options of this command
   * @returns the record, once the robot has finished
   */
  turn180(options: CommandOptions = {}): Promise<CommandRecord> {
    return this.#do("turn180", { action: "turn 180" }, options, "ended");
  }

  /**
   * Drives 50 cm forward, turns left, and drives 60 cm out of the junction.
   * @param options options of this command
   * @returns the record, once the robot has finished
   */
  delayedLeft90(options: CommandOptions = {}): Promise<CommandRecord> {
    return this.#do("delayedLeft90", { action: "delayed left 90" }, options, "ended");
  }

  /**
   * Drives 50 cm forward, turns right, and drives 60 cm out of the junction.
   * @param options options of this command
   * @returns the record, once the robot has finished
   */
  delayedRight90(options: CommandOptions = {}): Promise<CommandRecord> {
    return this.#do("delayedRight90", { action: "delayed right 90" }, options, "ended");
  }

  /**
   * Drives straight ahead.
   * @param distance cm, -25600 to 25600; negative is backward
   * @param options options of this command
   * @returns the record, once the robot has finished; `state` is `collided` if the robot met a wall
   */
  move(distance: number, options: CommandOptions = {}): Promise<CommandRecord> {
    return this.#do("move", { action: "move", distance }, options, "ended");
  }

  /**
   * Turns on the spot.
   * @param degrees -3600 to 3600; negative is left
   * @param options options of this command
   * @returns the record, once the robot has finished
   */
  turn(degrees: number, options: CommandOptions = {}): Promise<CommandRecord> {
    return this.#do("turn", { action: "turn", degrees }, options, "ended");
  }

  /**
   * Sets the power of the two wheels.
   *
   * Without a time and `until` it is a velocity: the robot stops after half a second unless another one
   * follows. Of several unsent velocities, only the newest is sent, and all of them resolve with
   * it.
   * @param left power of the left wheel, -1 to 1; negative is backward
   * @param right power of the right wheel, -1 to 1
   * @param milliseconds 1 to 60000; omit it for a velocity, or for `until`
   * @param options options of this command; `lease` only applies to velocities
   * @returns the record, once the robot has finished; for a velocity, once it has started
   */
  drive(
    left: number,
    right: number,
    milliseconds?: number,
    options: DriveOptions = {},
  ): Promise<CommandRecord> {
    const command: Order = { action: "drive", left, right };
    if (milliseconds === undefined) return this.#move("drive", command, options);
    return this.#do("drive", { ...command, milliseconds }, options, "ended");
  }

  /**
   * Reads the four range sensors.
   * @returns the distances in cm, all of one tick, newer than those of the last call
   * @throws ClientError robot-gone if the robot does not report
   */
  sensors(): Promise<SensorReadings> {
    return withCallSite(this, "sensors", async () => {
      return (await this.#connection.snapshots.next(this.#connection.api.timeoutMs)).sensors;
    });
  }

  /**
   * Reads everything that the robot reports.
   * @returns a newer snapshot than at the last call, never from before the end of the last command
   * @throws ClientError robot-gone if the robot does not report
   */
  snapshot(): Promise<Snapshot> {
    return withCallSite(this, "snapshot", () =>
      this.#connection.snapshots.next(this.#connection.api.timeoutMs),
    );
  }

  /**
   * Follows the robot until `close`: `for await (const snapshot of robot.snapshots())`.
   * @returns about 20 snapshots a second; a slow reader gets only the newest. When the page closes
   * or sleeps, the last snapshot is repeated with the state `gone` or `paused`
   */
  async *snapshots(): AsyncGenerator<Snapshot, void, void> {
    let read: Snapshot | null = null;
    for (;;) {
      read = await this.#connection.snapshots.changedFrom(read);
      if (read === null) return;
      yield read;
    }
  }

  /**
   * Follows the robot and the commands of all scripts until `close`.
   * @returns events in order; a slow reader gets the newest snapshot, and every state of a command
   */
  events(): AsyncGenerator<RobotEvent, void, void> {
    return this.#connection.events();
  }

  /**
   * Reads the robot's maze.
   * @returns its blocks, its start and its goals
   * @throws ClientError no-maze if the robot's host does not publish it
   */
  maze(): Promise<RobotMaze> {
    return withCallSite(this, "maze", async () => {
      const end = this.#connection.end();
      if (end !== null) throw end;
      return readMaze(this.#connection.api);
    });
  }

  /**
   * Closes the connection. Unfinished commands reject with the code `closed`. The robot finishes
   * the commands that it has received; endless motions stop within 3 s.
   */
  close(): void {
    this.#connection.close(
      new ClientError(
        "closed",
        "The client was closed",
        "Write await before each call, and call close() last. To continue, connect again.",
      ),
    );
  }

  /** Sends a motion without an end, or a guarded one. */
  #move(
    name: "forward" | "reverse" | "drive",
    command: Order,
    options: MotionOptions,
  ): Promise<CommandRecord> {
    const isGuarded = options?.until !== undefined;
    return this.#do(name, command, options, isGuarded ? "ended" : "started");
  }

  #do(
    name: CommandName,
    command: Order,
    options: DriveOptions,
    until: Until,
  ): Promise<CommandRecord> {
    return withCallSite(this, name, async () => {
      const wrong = wrongOptions(name, options);
      if (wrong !== null) throw wrong;
      const { until: conditions, ...others } = options;
      const guard = conditions === undefined ? {} : { until: [conditions].flat() };
      return this.#send({ ...command, ...others, ...guard }, until);
    });
  }

  #send(requested: Order, until: Until): Promise<CommandRecord> {
    // A stop must not expire early on a slow network.
    const order = requested.action === "stop" ? requested : { ...this.#defaults, ...requested };
    const checked = readValue(orderSchema, order);
    if (!checked.ok) {
      const hint = `Fix: ${checked.problems.map(describeProblem).join("; ")}.`;
      return Promise.reject(new ClientError("bad-command", "Invalid command", hint));
    }
    const end = this.#connection.end();
    if (end !== null) return Promise.reject(end);
    if (isWatchKey(this.#robot.key)) return Promise.reject(watchLinkError());
    return this.#connection.command(order, until);
  }
}
