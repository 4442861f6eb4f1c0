import {
  decodeFrame,
  encodeFrame,
  PROTOCOL_VERSION,
  relayToDriverSchema,
  sinceOf,
  type CommandRecord,
  type Marks,
  type Obstacle,
  type Order,
  type RelayToDriver,
  type RobotAddress,
  type Snapshot,
} from "@corridor/protocol";
import type { ApiOptions } from "./api-request.ts";
import { ClientError } from "./client-error.ts";
import type { ClientObserver, ClientParts } from "./client-parts.ts";
import { closeError, isWatchKey } from "./close-error.ts";
import { CommandQueue, type Until } from "./command-queue.ts";
import { Connection, type ConnectionStatus } from "./connection.ts";
import { connectionUrls } from "./connection-urls.ts";
import { DelayedAcknowledgements } from "./delayed-acknowledgements.ts";
import { EventInbox, type RobotEvent } from "./event-inbox.ts";
import { SilentRobotNotice, UnreachableNotice } from "./notices.ts";
import type { Platform } from "./platform.ts";
import { RobotObstacle } from "./robot-obstacle.ts";
import { SnapshotInbox } from "./snapshot-inbox.ts";

export interface DriverConnectionOptions {
  platform: Platform;
  /** timeout for responses of the relay in ms, including reconnects */
  responseMs: number;
  /** timeout for the robot to finish a command in ms */
  finishMs: number;
  /** name of the script, as it is sent */
  name: string | undefined;
}

/**
 * A script's connection to a robot: what the script has received, and its commands that have not
 * ended. After `close` it cannot be opened again.
 */
export class DriverConnection implements ClientParts {
  readonly api: ApiOptions;
  readonly snapshots: SnapshotInbox;
  readonly observers = new Set<ClientObserver>();
  readonly #robot: RobotAddress;
  readonly #name: { name?: string };
  readonly #connection: Connection<RelayToDriver>;
  readonly #events = new Set<EventInbox>();
  readonly #acknowledgements = new DelayedAcknowledgements();
  readonly #commands: CommandQueue;
  readonly #obstacle = new RobotObstacle();
  readonly #silence: SilentRobotNotice;
  readonly #unreachable: UnreachableNotice;
  #welcomed: () => void = () => undefined;
  #notWelcomed: (reason: ClientError) => void = () => undefined;
  /** the last received state: its stream, and the value for `since` */
  #stream = "";
  #since: string | null = null;
  #end: ClientError | null = null;

  constructor(
    robot: RobotAddress,
    { platform, responseMs, finishMs, name }: DriverConnectionOptions,
  ) {
    const { origin, id, key } = robot;
    this.#robot = robot;
    this.#name = name === undefined ? {} : { name };
    const api = `${origin}/api/v1/robots/${id}`;
    this.api = { platform, api, key, timeoutMs: responseMs };
    const { clock } = platform;
    const warn = (text: string): void => platform.warn?.(text);
    this.snapshots = new SnapshotInbox(clock, warn);
    this.#silence = new SilentRobotNotice(clock, warn);
    this.#unreachable = new UnreachableNotice(clock, warn, origin);
    this.#connection = new Connection({
      urls: connectionUrls(origin, "robots", id),
      platform,
      firstMessages: () => [this.#hello()],
      decode: (text) => decodeFrame(relayToDriverSchema, text),
      received: (message) => {
        this.#received(message);
        for (const observer of this.observers) observer.received(message);
      },
      changed: (status) => this.#changed(status),
    });
    this.#commands = new CommandQueue({
      platform,
      responseMs,
      finishMs,
      connection: this.#connection,
      waits: (isWaiting) => this.#silence.waits(isWaiting),
    });
  }

  /**
   * Connects.
   * @returns once the relay has accepted the key
   * @throws ClientError of the end of the connection, or `timeout`
   */
  async open(): Promise<void> {
    const cancelTimer = this.api.platform.clock.after(this.api.timeoutMs, () =>
      this.close(
        new ClientError(
          "timeout",
          "The robot's host does not respond",
          `Check the network, and that the robot is at ${this.#robot.origin}.`,
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

  newest(): Snapshot | null {
    return this.snapshots.newest;
  }

  obstacle(): Obstacle | null {
    return this.#obstacle.current;
  }

  end(): ClientError | null {
    return this.#end;
  }

  send(order: Order, key: string | undefined): Promise<CommandRecord> {
    return this.#commands.add(order, "accepted", key);
  }

  mark(marks: Marks): void {
    if (this.#connection.isConnected)
      this.#connection.send(encodeFrame({ type: "marks", ...marks }));
  }

  /** Sends a valid command. @returns the record, once the command has the state `until` */
  command(order: Order, until: Until): Promise<CommandRecord> {
    return this.#commands.add(order, until);
  }

  /** @returns events until `close`, in order */
  events(): AsyncGenerator<RobotEvent, void, void> {
    const inbox = new EventInbox();
    if (this.#end === null) this.#events.add(inbox);
    else inbox.close();
    const snapshot = this.newest();
    if (snapshot !== null) inbox.put({ kind: "snapshot", snapshot });
    return this.#eventsOf(inbox);
  }

  /** Ends the connection and everything that waits; the first call counts. */
  close(error: ClientError): void {
    if (this.#end !== null) return;
    this.#end = error;
    this.#connection.close();
    this.#unreachable.close();
    this.#notWelcomed(error);
    this.#commands.close(error);
    this.snapshots.close(error);
    for (const inbox of this.#events) inbox.close();
    for (const observer of this.observers) observer.ended(error);
  }

  #hello(): string {
    const { key } = this.#robot;
    const since = this.#since === null ? {} : { since: this.#since };
    // A watch key permits reading only.
    const role = isWatchKey(key) ? "watch" : "drive";
    const hello = { type: "hello", version: PROTOCOL_VERSION, role, key } as const;
    return encodeFrame({ ...hello, ...since, ...this.#name, sentAt: this.#commands.start() });
  }

  #received(message: RelayToDriver): void {
    switch (message.type) {
      case "welcome":
        // In a new stream earlier states are lost.
        this.#commands.welcomed(message.stream === this.#stream);
        this.#stream = message.stream;
        if (message.n !== null) this.#setSince(message.n);
        this.#acknowledgements.reset();
        if (message.snapshot !== null) this.#read(message.snapshot);
        return;
      case "snapshot":
        return this.#read(message.snapshot);
      case "ack":
        return this.#commands.acknowledged(message.record);
      case "state":
        this.#setSince(message.n);
        this.#publish({ kind: "command", command: message.record });
        return this.#commands.progressed(message.record);
      case "gap":
        this.#setSince(message.n);
        this.#publish({ kind: "gap" });
        return this.#commands.missed();
      case "problem":
        return this.#commands.refused(message.problem, message.key);
      case "maze":
      case "marks":
      case "heartbeat":
        return;
    }
  }

  #read(snapshot: Snapshot): void {
    this.snapshots.put(snapshot);
    this.#obstacle.read(snapshot);
    this.#silence.found(this.#obstacle.current);
    this.#publish({ kind: "snapshot", snapshot });
    // The next long poll acknowledges it.
    if (this.#connection.transport === "long-poll") return;
    if (!this.#acknowledgements.read(this.api.platform.clock.now())) return;
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

  #setSince(n: number): void {
    this.#since = sinceOf(this.#stream, n);
  }

  #changed(status: ConnectionStatus): void {
    this.#unreachable.changed(status);
    if (status.kind === "over") return this.close(closeError(status.reason, this.#robot));
    if (status.kind !== "connected") return;
    this.#welcomed();
    this.#commands.connected();
  }
}
