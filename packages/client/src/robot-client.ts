/**
 * A robot that a script drives.
 *
 * Commands are sent one after the other; a manoeuvre's promise resolves when the robot has finished it, that of a
 * motion without an end when the robot has started it.
 */
import {
  decodeFrame,
  describeProblem,
  encodeFrame,
  hasEnded,
  orderSchema,
  PROTOCOL_VERSION,
  readValue,
  relayToDriverSchema,
  sinceOf,
  TTL_MS,
  type CommandRecord,
  type Order,
  type ProblemDocument,
  type RelayToDriver,
  type SensorReadings,
  type Snapshot,
} from "@corridor/protocol";
import { ClientError } from "./client-error.ts";
import { closeError } from "./close-error.ts";
import { CommandTimes } from "./command-times.ts";
import { Connection, type ConnectionStatus } from "./connection.ts";
import { EventInbox, type RobotEvent } from "./event-inbox.ts";
import { pairRobot } from "./pairing.ts";
import { globalPlatform, type Platform } from "./platform.ts";
import { parseRobotAddress, doorUrls } from "./robot-address.ts";
import { readMaze, type RobotMaze } from "./robot-maze.ts";
import { SeenPace } from "./delayed-acknowledgements.ts";
import { SnapshotInbox } from "./snapshot-inbox.ts";

/** Further terms of a command. */
export interface CommandWish {
  /**
   * ms within which the command must start, or it ends as `expired`: 200 to 60000; default: `ttl` of the robot. It
   * must be longer than the way to the robot and back
   */
  ttl?: number;
  /** `true` ends every command that was sent before as `superseded`, and starts this one at once */
  replace?: boolean;
}

/** Further terms of a `drive`. */
export interface DriveWish extends CommandWish {
  /** ms for which the robot goes on when no other `drive` follows: 100 to 2000; default 500 */
  lease?: number;
}

/** What `connect` and `pair` take. */
export interface RobotClientOptions {
  /** ms within which a command must start, where it has no `ttl` of its own; default 10 s. Not for `stop` */
  ttl?: number;
  /** what this script calls itself, for the robot's owner; 40 characters are shown */
  name?: string;
  /** ms to wait for the relay's answer, reconnecting included; default 30 s */
  answerTimeout?: number;
  /** ms to wait until the robot has finished a command; default 10 minutes */
  finishTimeout?: number;
  /** WebSocket, HTTP, clock and chance, to replace in tests; default: those of the browser or of Node */
  platform?: Platform;
}

interface Pending {
  key: string;
  order: Order;
  /** when it was sent for the first time */
  triedAt: number | null;
  /** how often it was refused as too late although the answer came in time */
  doubts: number;
  /** what keeps the promise */
  until: "started" | "ended";
  resolve: (record: CommandRecord) => void;
  reject: (error: ClientError) => void;
  cancelTimer(): void;
}

const DEFAULT_ANSWER_MS = 30_000;
const DEFAULT_FINISH_MS = 600_000;
/** The relay refuses a hello with a longer name; it shows less than that. */
const MAX_SENT_NAME = 200;
/** Pause before a command is sent again that the relay could not take yet. */
const BUSY_PAUSE_MS = 500;

/**
 * A robot on the network, in a page or on a table.
 *
 * Methods that drive resolve with the record of their command. `completed` and `collided` (a wall was in the way) are
 * both no error. They reject with a `ClientError`: `bad-command` for a number out of its range, `refused` where the relay
 * refused the command, `cancelled`, `superseded` or `expired` where it did not come to its end, `timeout` where the relay
 * or the robot took too long, and `closed`.
 *
 * After a lost connection a command is sent again with its idempotency key and its age, so none is done twice or late.
 */
export class RobotClient {
  /** the whole address, with its key, for the next time. Keep it private */
  readonly address: string;
  readonly #key: string;
  /** where the robot's calls begin */
  readonly #api: string;
  readonly #platform: Platform;
  readonly #answerMs: number;
  readonly #finishMs: number;
  readonly #wish: CommandWish;
  readonly #name: { name?: string };
  readonly #connection: Connection<RelayToDriver>;
  readonly #inbox: SnapshotInbox;
  readonly #events = new Set<EventInbox>();
  readonly #seen = new SeenPace();
  readonly #times: CommandTimes;
  #welcomed: () => void = () => undefined;
  #notWelcomed: (reason: ClientError) => void = () => undefined;
  /** not yet acknowledged on this line, in order; only the first is on its way */
  #queue: Pending[] = [];
  /** acknowledged and not yet done, by seq */
  readonly #running = new Map<number, Pending>();
  /** the last state that was told: this series of numbers, and the number */
  #stream = "";
  #since: string | null = null;
  #cancelRetry: () => void = () => undefined;
  #end: ClientError | null = null;

  private constructor(address: string, options: RobotClientOptions) {
    const { origin, id, key } = parseRobotAddress(address);
    this.#key = key;
    this.address = `${origin}/r/${id}#${key}`;
    this.#api = `${origin}/api/v1/robots/${id}`;
    this.#platform = options.platform ?? globalPlatform();
    this.#answerMs = options.answerTimeout ?? DEFAULT_ANSWER_MS;
    this.#finishMs = options.finishTimeout ?? DEFAULT_FINISH_MS;
    this.#wish = options.ttl === undefined ? {} : { ttl: options.ttl };
    this.#name = options.name === undefined ? {} : { name: options.name.slice(0, MAX_SENT_NAME) };
    this.#inbox = new SnapshotInbox(this.#platform.clock);
    this.#times = new CommandTimes(this.#platform.clock);
    this.#connection = new Connection({
      urls: doorUrls(origin, id),
      platform: this.#platform,
      greeting: () => [this.#hello()],
      decode: (text) => decodeFrame(relayToDriverSchema, text),
      received: (message) => this.#received(message),
      changed: (status) => this.#changed(status),
    });
  }

  /**
   * Connects to a robot.
   * @param address `http://HOST/r/ID#KEY`, as the robot's page shows it under Remote
   * @param options time limits and a name
   * @returns the robot, once the relay has accepted the key
   * @throws ClientError bad-address, not-authorised, blocked, no-robot or timeout
   */
  static async connect(address: string, options: RobotClientOptions = {}): Promise<RobotClient> {
    const robot = new RobotClient(address, options);
    await robot.#open();
    return robot;
  }

  /**
   * Connects by a code of 8 letters, and waits until the robot's owner accepts this script. `address` of the robot
   * works the next time without a code.
   * @param service where the robot's page is, such as `http://HOST`
   * @param code the code that the page shows under Remote; spaces and small letters are accepted
   * @param options time limits and a name, which the page shows in its question to the owner
   * @returns the robot, once it is connected
   * @throws ClientError wrong-code, pairing-refused, pairing-over, too-many-tries, or as `connect`
   */
  static async pair(
    service: string,
    code: string,
    options: RobotClientOptions = {},
  ): Promise<RobotClient> {
    const { platform = globalPlatform(), answerTimeout = DEFAULT_ANSWER_MS, name } = options;
    const wish = { service, code, name: name?.slice(0, MAX_SENT_NAME) ?? null };
    const address = await pairRobot(platform, wish, answerTimeout);
    return RobotClient.connect(address, { ...options, platform });
  }

  /**
   * Drives forward until another command comes. The robot stops by itself within 3 s after this client was closed.
   * @param wish further terms of this command
   * @returns the record, once the robot has started
   */
  forward(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "forward", ...wish }, "started");
  }

  /**
   * Drives backward until another command comes, as `forward` does.
   * @param wish further terms of this command
   * @returns the record, once the robot has started
   */
  reverse(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "reverse", ...wish }, "started");
  }

  /**
   * Stops at once: cancels the running command and all waiting ones, from every script.
   * @param wish further terms of this command; it has a `ttl` of 10 s where none is given
   * @returns the record, once the robot stands
   */
  stop(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "stop", ...wish }, "ended");
  }

  /**
   * Turns left by 90 degrees on the spot.
   * @param wish further terms of this command
   * @returns the record, once the robot has finished
   */
  left90(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "left 90", ...wish }, "ended");
  }

  /**
   * Turns right by 90 degrees on the spot.
   * @param wish further terms of this command
   * @returns the record, once the robot has finished
   */
  right90(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "right 90", ...wish }, "ended");
  }

  /**
   * Turns by 180 degrees on the spot.
   * @param wish further terms of this command
   * @returns the record, once the robot has finished
   */
  turn180(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "turn 180", ...wish }, "ended");
  }

  /**
   * Drives on 50 cm, turns left, drives 60 cm out of the junction.
   * @param wish further terms of this command
   * @returns the record, once the robot has finished
   */
  delayedLeft90(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "delayed left 90", ...wish }, "ended");
  }

  /**
   * Drives on 50 cm, turns right, drives 60 cm out of the junction.
   * @param wish further terms of this command
   * @returns the record, once the robot has finished
   */
  delayedRight90(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "delayed right 90", ...wish }, "ended");
  }

  /**
   * Drives straight on.
   * @param distance cm, -25600 to 25600; negative is backward
   * @param wish further terms of this command
   * @returns the record, once the robot has finished; `state` is `collided` where a wall was in the way
   */
  move(distance: number, wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "move", distance, ...wish }, "ended");
  }

  /**
   * Turns on the spot.
   * @param degrees -3600 to 3600; negative is left
   * @param wish further terms of this command
   * @returns the record, once the robot has finished
   */
  turn(degrees: number, wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "turn", degrees, ...wish }, "ended");
  }

  /**
   * Sets the power of the two wheels.
   *
   * Without a time it is a velocity: the robot stops after half a second unless another one follows. Of velocities that
   * could not be sent yet only the newest is sent, and all of them resolve with it.
   * @param left power of the left wheel, -1 to 1; negative is backward
   * @param right power of the right wheel, -1 to 1
   * @param milliseconds 1 to 60000; left out: a velocity
   * @param wish further terms of this command; `lease` is for velocities
   * @returns the record, once the time is over; for a velocity, once the robot has started
   */
  drive(
    left: number,
    right: number,
    milliseconds?: number,
    wish: DriveWish = {},
  ): Promise<CommandRecord> {
    const order: Order = { action: "drive", left, right, ...wish };
    if (milliseconds === undefined) return this.#do(order, "started");
    return this.#do({ ...order, milliseconds }, "ended");
  }

  /**
   * Reads the four distances.
   * @returns the distances in cm, all of one tick, newer than those of the last call
   * @throws ClientError robot-gone when the robot stays silent
   */
  async sensors(): Promise<SensorReadings> {
    return (await this.snapshot()).sensors;
  }

  /**
   * Reads everything that the robot reports.
   * @returns a newer snapshot than at the last call, never from before the end of the last command
   * @throws ClientError robot-gone when the robot stays silent
   */
  snapshot(): Promise<Snapshot> {
    return this.#inbox.next(this.#answerMs);
  }

  /**
   * Follows the robot until `close`: `for await (const snapshot of robot.snapshots())`.
   * @returns one snapshot after the other, about 20 a second; a slow reader gets the newest each time. When the page
   * is closed or sleeps, the last one comes again with the state `gone` or `paused`
   */
  async *snapshots(): AsyncGenerator<Snapshot, void, void> {
    let read: Snapshot | null = null;
    for (;;) {
      read = await this.#inbox.changedFrom(read);
      if (read === null) return;
      yield read;
    }
  }

  /**
   * Follows the robot and the commands of all scripts until `close`.
   * @returns events in their order; a slow reader gets the newest snapshot, and every state of a command
   */
  events(): AsyncGenerator<RobotEvent, void, void> {
    const inbox = new EventInbox();
    if (this.#end === null) this.#events.add(inbox);
    else inbox.close();
    const snapshot = this.#inbox.newest;
    if (snapshot !== null) inbox.put({ kind: "snapshot", snapshot });
    return this.#eventsOf(inbox);
  }

  /**
   * Reads the maze that the robot is in.
   * @returns its blocks, its start and its goals
   * @throws ClientError no-maze where the robot's host does not publish it
   */
  async maze(): Promise<RobotMaze> {
    if (this.#end !== null) throw this.#end;
    return readMaze({
      platform: this.#platform,
      api: this.#api,
      key: this.#key,
      answerMs: this.#answerMs,
    });
  }

  /**
   * Closes the connection. Commands that have not ended are rejected with the code `closed`; what the robot has, it
   * finishes, and motions without an end stop within 3 s.
   */
  close(): void {
    this.#finish(new ClientError("closed", "The client was closed", "Connect again to go on."));
  }

  async #open(): Promise<void> {
    const cancelTimer = this.#platform.clock.after(this.#answerMs, () =>
      this.#finish(
        new ClientError(
          "timeout",
          "The service does not answer",
          "Check that it runs, that the address is right and that this computer has a network.",
        ),
      ),
    );
    try {
      await new Promise<void>((resolve, reject) => {
        this.#welcomed = resolve;
        this.#notWelcomed = reject;
        this.#connection.open();
      });
    } finally {
      cancelTimer();
    }
  }

  #do(wished: Order, until: Pending["until"]): Promise<CommandRecord> {
    // A stop is wished for all the more where the network is slow.
    const order = wished.action === "stop" ? wished : { ...this.#wish, ...wished };
    const checked = readValue(orderSchema, order);
    if (!checked.ok) {
      const hint = `Mend this: ${checked.problems.map(describeProblem).join("; ")}.`;
      return Promise.reject(new ClientError("bad-command", "The command is wrong", hint));
    }
    if (this.#end !== null) return Promise.reject(this.#end);
    return new Promise((resolve, reject) => {
      const key = this.#platform.uniqueText();
      const pending: Pending = {
        key,
        order,
        triedAt: null,
        doubts: 0,
        until,
        resolve,
        reject,
        cancelTimer: () => undefined,
      };
      this.#limit(pending, this.#answerMs, "The relay does not answer");
      this.#queue.push(pending);
      if (this.#queue.length === 1) this.#sendFirst();
    });
  }

  #hello(): string {
    const key = this.#key;
    const since = this.#since === null ? {} : { since: this.#since };
    // A watch key reads all there is; commands are refused by the service.
    const role = key.startsWith("wch_") ? "watch" : "drive";
    const greeting = { type: "hello", version: PROTOCOL_VERSION, role, key } as const;
    return encodeFrame({ ...greeting, ...since, ...this.#name, sentAt: this.#times.begin() });
  }

  #sendFirst(): void {
    if (!this.#connection.isConnected) return;
    this.#passOverOldVelocities();
    const [first] = this.#queue;
    if (first === undefined) return;
    const { clock } = this.#platform;
    const triedAt = (first.triedAt ??= clock.now());
    const { key, order } = first;
    this.#connection.send(() => {
      const { sentAt, age } = this.#times.leaves(triedAt);
      const command = age === 0 ? order : { ...order, age };
      return encodeFrame({ type: "command", key, sentAt, command });
    });
  }

  /** What was wished while the line was down must not move the robot bit by bit once it is back. */
  #passOverOldVelocities(): void {
    for (;;) {
      const [older, newer] = this.#queue;
      if (newer === undefined || older === undefined) return;
      if (!isVelocity(older.order) || !isVelocity(newer.order) || older.order.replace === true)
        return;
      this.#queue.shift();
      older.cancelTimer();
      const { resolve, reject } = newer;
      newer.resolve = (record) => {
        older.resolve(record);
        resolve(record);
      };
      newer.reject = (error) => {
        older.reject(error);
        reject(error);
      };
    }
  }

  #limit(pending: Pending, ms: number, what: string): void {
    pending.cancelTimer();
    pending.cancelTimer = this.#platform.clock.after(ms, () => {
      this.#forget(pending);
      const hint = "Check that the robot's page is open, connected and not paused.";
      pending.reject(new ClientError("timeout", what, hint));
    });
  }

  #forget(pending: Pending): void {
    pending.cancelTimer();
    const wasFirst = this.#queue[0] === pending;
    this.#queue = this.#queue.filter((other) => other !== pending);
    for (const [seq, other] of this.#running) if (other === pending) this.#running.delete(seq);
    if (wasFirst) this.#sendFirst();
  }

  #received(message: RelayToDriver): void {
    switch (message.type) {
      case "welcome":
        this.#times.answered();
        // A relay that counts anew has forgotten what this client was told; one that goes on tells the rest.
        if (message.stream !== this.#stream) this.#askAgain();
        this.#stream = message.stream;
        if (message.n !== null) this.#told(message.n);
        this.#seen.begin();
        if (message.snapshot !== null) this.#read(message.snapshot);
        return;
      case "snapshot":
        return this.#read(message.snapshot);
      case "ack":
        return this.#acknowledged(message.record);
      case "state":
        this.#told(message.n);
        this.#publish({ kind: "command", command: message.record });
        return this.#progressed(message.record);
      case "gap":
        this.#told(message.n);
        this.#publish({ kind: "gap" });
        this.#askAgain();
        return this.#sendFirst();
      case "problem":
        return this.#refused(message.problem, message.key);
      case "maze":
      case "heartbeat":
        return;
    }
  }

  #read(snapshot: Snapshot): void {
    this.#inbox.put(snapshot);
    this.#publish({ kind: "snapshot", snapshot });
    // By HTTPS the next request says it already.
    if (this.#connection.door === "https") return;
    if (!this.#seen.read(this.#platform.clock.now())) return;
    this.#connection.send(encodeFrame({ type: "seen", seq: snapshot.seq }));
  }

  async *#eventsOf(inbox: EventInbox): AsyncGenerator<RobotEvent, void, void> {
    try {
      for (;;) {
        const event = await inbox.next();
        if (event === null) return;
        yield event;
      }
    } finally {
      this.#events.delete(inbox);
    }
  }

  #publish(event: RobotEvent): void {
    for (const inbox of this.#events) inbox.put(event);
  }

  #told(n: number): void {
    this.#since = sinceOf(this.#stream, n);
  }

  /** States were missed: asking again with the same key gives each record as it is now. */
  #askAgain(): void {
    this.#queue = [...this.#running.values(), ...this.#queue];
    this.#running.clear();
  }

  #acknowledged(record: CommandRecord): void {
    const [first] = this.#queue;
    if (first === undefined || first.key !== record.key) return;
    this.#times.answered();
    this.#queue.shift();
    this.#limit(first, this.#finishMs, "The robot does not finish");
    this.#running.set(record.seq, first);
    this.#progressed(record);
    this.#sendFirst();
  }

  #progressed(record: CommandRecord): void {
    const pending = this.#running.get(record.seq);
    if (pending === undefined) return;
    const { state } = record;
    const isLost = state === "cancelled" || state === "expired";
    if (isLost || (state === "superseded" && pending.until === "ended")) {
      this.#forget(pending);
      const ended = state === "expired" ? state : `was ${state}`;
      const what = `Command ${record.seq} (${record.action}) ${ended}`;
      const hint = record.reason ?? "Somebody else drives this robot too.";
      return pending.reject(new ClientError(state, what, hint));
    }
    if (hasEnded(state) || (state === "started" && pending.until === "started")) {
      this.#forget(pending);
      pending.resolve(record);
    }
  }

  #refused(problem: ProblemDocument, key: string | null): void {
    const [first] = this.#queue;
    if (first === undefined || (key !== null && key !== first.key)) return;
    if (key !== null) this.#times.answered();
    if (problem.status === 429 || problem.status >= 500) {
      this.#cancelRetry();
      this.#cancelRetry = this.#platform.clock.after(BUSY_PAUSE_MS, () => this.#sendFirst());
      return;
    }
    const isLate = problem.type === "/problems/too-late";
    if (isLate && this.#isInTime(first)) return this.#doubt(first);
    this.#forget(first);
    const code = isLate ? "expired" : "refused";
    first.reject(new ClientError(code, problem.title, problem.detail));
  }

  /** Whether a command is younger than its time to live, whatever the relay thinks. */
  #isInTime({ triedAt, order, doubts }: Pending): boolean {
    const passed = this.#platform.clock.now() - (triedAt ?? 0);
    return doubts < 2 && passed < (order.ttl ?? TTL_MS.default);
  }

  /**
   * The relay thought a command too old that is not: its answer has shown a quicker way, or this computer has slept
   * and its clock stood still. Then a new connection measures anew.
   */
  #doubt(first: Pending): void {
    first.doubts += 1;
    if (first.doubts === 1) return this.#sendFirst();
    this.#connection.close();
    this.#connection.open();
  }

  #changed(status: ConnectionStatus): void {
    if (status.kind === "over") return this.#finish(closeError(status.reason, this.#key));
    if (status.kind !== "connected") return;
    this.#welcomed();
    // The answer to what was on its way may be lost. What was acknowledged is told from `since` on.
    this.#sendFirst();
  }

  #finish(error: ClientError): void {
    if (this.#end !== null) return;
    this.#end = error;
    this.#connection.close();
    this.#cancelRetry();
    this.#notWelcomed(error);
    for (const pending of [...this.#running.values(), ...this.#queue]) {
      pending.cancelTimer();
      pending.reject(error);
    }
    this.#running.clear();
    this.#queue = [];
    this.#inbox.close(error);
    for (const inbox of this.#events) inbox.close();
  }
}

/** Of which only the newest value counts: a drive without a time. */
function isVelocity(order: Order): boolean {
  return order.action === "drive" && order.milliseconds === undefined;
}
