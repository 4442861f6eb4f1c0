/**
 * A robot in the hands of a script.
 *
 * Every command carries an idempotency key and is sent again with it after a lost line, so a retry
 * never moves the robot twice. Commands are sent one after the other; a manoeuvre's promise is kept
 * when the robot has finished it, that of a motion without an end when the robot has begun.
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
import { SeenPace } from "./seen-pace.ts";
import { SnapshotInbox } from "./snapshot-inbox.ts";

/** What may be said beside a command. */
export interface CommandWish {
  /**
   * ms within which it must have started, or it ends as `expired`; default 10 s, or as `connect` was told. The
   * way to the robot and back counts, so a slow network needs a longer one
   */
  ttl?: number;
  /** ends all that was sent before it */
  replace?: boolean;
}

export interface DriveWish extends CommandWish {
  /** ms for which the robot goes on when no other drive follows; default 500 */
  lease?: number;
}

export interface RobotClientOptions {
  /** ms within which a command must have started, where it says nothing else; default 10 s. Not for `stop` */
  ttl?: number;
  /** what this script calls itself, for the robot's owner; at most 40 characters are shown */
  name?: string;
  /** ms to wait for the relay's answer, reconnecting included; default 30 s */
  answerTimeout?: number;
  /** ms to wait until the robot has done a command; default 10 minutes */
  finishTimeout?: number;
  /** default: what browsers and Node offer */
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

export class RobotClient {
  /** the whole address, with its key, for the next time: keep it private */
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
   * @param address `http://HOST/r/ID#KEY`, as the page shows it under Remote
   * @throws ClientError bad-address, not-authorised, sent-away, no-robot or timeout
   */
  static async connect(address: string, options: RobotClientOptions = {}): Promise<RobotClient> {
    const robot = new RobotClient(address, options);
    await robot.#open();
    return robot;
  }

  /**
   * Connects to the robot whose page shows a code, typed by hand in place of the address. Waits until whoever
   * has the page says yes; `address` can be kept for the next time.
   * @param service where that page is, such as `http://HOST`
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

  /** Drives until something else is chosen; resolves when the robot has begun. */
  forward(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "forward", ...wish }, "started");
  }

  /** Drives backward until something else is chosen; resolves when the robot has begun. */
  reverse(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "reverse", ...wish }, "started");
  }

  /** Stops at once: ends what runs, and drops what waits, whoever sent it. */
  stop(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "stop", ...wish }, "ended");
  }

  /** Turns left by 90 degrees on the spot. */
  left90(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "left 90", ...wish }, "ended");
  }

  /** Turns right by 90 degrees on the spot. */
  right90(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "right 90", ...wish }, "ended");
  }

  /** Turns round on the spot. */
  turn180(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "turn 180", ...wish }, "ended");
  }

  /** Drives on 50 cm, turns left, drives 60 cm out of the junction. */
  delayedLeft90(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "delayed left 90", ...wish }, "ended");
  }

  /** Drives on 50 cm, turns right, drives 60 cm out of the junction. */
  delayedRight90(wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "delayed right 90", ...wish }, "ended");
  }

  /** Drives so many cm; negative is backward. The record says `collided` where a wall was in the way. */
  move(distance: number, wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "move", distance, ...wish }, "ended");
  }

  /** Turns by so many degrees on the spot; negative is left. */
  turn(degrees: number, wish: CommandWish = {}): Promise<CommandRecord> {
    return this.#do({ action: "turn", degrees, ...wish }, "ended");
  }

  /**
   * Sets the wheel powers, each from -1 to 1, for so many milliseconds. Resolves when the time is over.
   * Without a time it is a velocity: the robot stops after half a second unless another one follows, and
   * this resolves when it has begun. Of velocities that could not be sent yet only the newest is, and all
   * of them resolve with it.
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

  /** The four distances in cm, all of one tick, newer than those of the last call. */
  async sensors(): Promise<SensorReadings> {
    return (await this.snapshot()).sensors;
  }

  /**
   * All that the robot reports, newer than at the last call: after a command has ended it is never
   * from before the end.
   * @throws ClientError robot-gone when the robot stays silent
   */
  snapshot(): Promise<Snapshot> {
    return this.#inbox.next(this.#answerMs);
  }

  /** Every snapshot as it comes (about 20 a second); a slow reader gets the newest each time. */
  async *snapshots(): AsyncGenerator<Snapshot, void, void> {
    let seq = -1;
    for (;;) {
      const snapshot = await this.#inbox.newerThan(seq);
      if (snapshot === null) return;
      seq = snapshot.seq;
      yield snapshot;
    }
  }

  /**
   * What happens from now on, as it happens: newer snapshots, and commands whose state changes, whoever
   * sent them. A slow reader gets the newest snapshot, and every state of a command.
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
   * The maze that the robot is in.
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

  /** Leaves the robot as it is. What was not done yet is rejected with the code `closed`. */
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
      const what = `Command ${record.seq} (${record.action}) was ${state}`;
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
