import {
  closeReasons,
  decodeFrame,
  encodeFrame,
  MAX_RESUMED_ENDINGS,
  PROTOCOL_VERSION,
  relayToPageSchema,
  type AliveDriver,
  type CloseReason,
  type CommandRecord,
  type DeliveredCommand,
  type Drivers,
  type Ending,
  type Marks,
  type PageToRelay,
  type RecallCause,
  type RelayToPage,
  type ScriptList,
  type Snapshot,
} from "@corridor/protocol";
import { AppliedCommands } from "./applied-commands.ts";
import { Connection, type ConnectionStatus } from "./connection.ts";
import { Outbox } from "./outbox.ts";
import { globalPlatform, type Platform } from "./platform.ts";
import { connectionUrls } from "./connection-urls.ts";
import { TransitClock } from "./transit-clock.ts";

/** Snapshots are dropped while more bytes are buffered. */
const MAX_BUFFERED_BYTES = 64 * 1024;

export type HostStatus =
  | { kind: "connecting" }
  | { kind: "connected" }
  /** the connection reconnects automatically after `retryMs` */
  | { kind: "lost"; reason: CloseReason; retryMs: number }
  /** the robot was deleted: register it again */
  | { kind: "over"; reason: CloseReason }
  /** another page took over the robot */
  | { kind: "replaced"; reason: CloseReason };

/** The state of commands that a page stores together with its world. */
export interface CommandJournal {
  lastApplied: number;
  /** endings that the relay has not confirmed as stored, oldest first */
  endings: Ending[];
}

export interface HostConnectionOptions {
  /** of the service, such as https://robots.example.org */
  origin: string;
  credentials: { id: string; ownerKey: string };
  /** highest seq that this page has ever started or ended; 0 if none */
  lastApplied: number;
  /** endings in the restored world that the relay may not have stored; default: none */
  endings?: readonly Ending[];
  /**
   * Stores the world together with `journal`. The connection sends an ending once this resolves:
   * either the world is stored, or no reload restores it. If another page has claimed the world,
   * call `worldClaimed` first.
   */
  save?(): Promise<void>;
  /** true if the page was reloaded, so that its started commands no longer run */
  fresh: boolean;
  /**
   * The current snapshot. Sent before each ending, so that readers never have older sensor values.
   */
  snapshot(): Snapshot | null;
  /** A new command. Commands arrive in order of their seq; start them in that order. */
  onCommand(command: DeliveredCommand): void;
  /** Call `ended` for all received commands before this returns. It ends the stop itself. */
  onStop(stop: DeliveredCommand): void;
  /** A command is to be cancelled: call `ended` for it, unless it has ended already. */
  onCancel(seq: number, cause: RecallCause): void;
  /**
   * Discard all received commands that have not started. The relay sends those still valid again.
   */
  onGiveBack(): void;
  /** Another page is acquiring the robot: call `ended` for what runs before this returns. */
  onYield(): void;
  /** A command that is not on this page: it waits at the relay, or has ended there. */
  onState(record: CommandRecord, ttl: number): void;
  /** The reported ending arrived after the command had ended like this. */
  onRefused(record: CommandRecord): void;
  /**
   * The relay has stored the reported ending. Before a `cancelled` one, `onState` has reported all
   * commands that waited at the relay.
   */
  onStored?(seq: number): void;
  /** A script has marked cells of the maze; fresh without cells: its marks end. */
  onMarks?(marks: Marks): void;
  onStatus(status: HostStatus): void;
  /**
   * The state of scripts, about once a second.
   * @param alive scripts whose endless motions may continue; stop them 3 s after their last message
   * @param owned all scripts by name, including blocked ones, and what the owner permits
   */
  onDrivers(drivers: Drivers, alive: readonly AliveDriver[], owned: ScriptList): void;
  /** default: the platform of browsers, workers and Node */
  platform?: Omit<Platform, "uniqueText">;
}

/**
 * The connection of the page that owns a robot: receives commands and reports their progress. It
 * can run in a worker.
 *
 * - It stores each ending until the relay confirms that it is stored, across reconnects, so that each
 *   command has exactly one ending.
 * - It never passes on a started command again, even if the relay repeats it.
 * - It returns unstarted commands to the relay on each reconnect, because the relay may have ended them.
 *
 * This also holds across `close` and `open`, so a session needs one object only.
 */
export class HostConnection {
  readonly #options: HostConnectionOptions;
  readonly #connection: Connection<RelayToPage>;
  /** endings that the relay has not confirmed as stored, by seq, oldest first */
  readonly #endings = new Map<number, Ending>();
  /** the endings among them that wait for `save` */
  readonly #unsaved = new Set<number>();
  readonly #outbox = new Outbox();
  /** `close` was called, and earlier endings are being saved */
  #isClosing = false;
  /** another page has claimed this page's world */
  #isReplaced = false;
  /** endings in the newest `resume` */
  #resumed = new Set<number>();
  #epoch = 1;
  /** identifies this page across its connections */
  readonly #page: string;
  /** another page acquires the robot: no command on this connection starts any more */
  #hasYielded = false;
  #fresh: boolean;
  readonly #clock: Platform["clock"];
  readonly #transit = new TransitClock();
  readonly #applied: AppliedCommands;

  /** Connects at once. */
  constructor(options: HostConnectionOptions) {
    this.#options = options;
    this.#fresh = options.fresh;
    this.#applied = new AppliedCommands(options.lastApplied);
    for (const ending of options.endings ?? []) this.#endings.set(ending.seq, ending);
    const { origin, credentials, platform = globalPlatform() } = options;
    this.#clock = platform.clock;
    this.#page = Math.floor(platform.random() * 2 ** 48)
      .toString(36)
      .padStart(10, "0");
    this.#connection = new Connection({
      urls: connectionUrls(origin, "robots", credentials.id),
      platform,
      firstMessages: () => this.#firstMessages(),
      decode: (text) => decodeFrame(relayToPageSchema, text),
      received: (message) => this.#received(message),
      changed: (status) => options.onStatus(hostStatus(status)),
    });
    this.#connection.open();
  }

  /** This command and all earlier ones have started or ended. Store it with the credentials. */
  get lastApplied(): number {
    return this.#applied.last;
  }

  /** To be stored together with the world. */
  get journal(): CommandJournal {
    return { lastApplied: this.#applied.last, endings: [...this.#endings.values()] };
  }

  get isConnected(): boolean {
    return this.#connection.isConnected && !this.#isClosing;
  }

  /**
   * Sends a snapshot. Call it up to 20 times a second while the robot moves, and at least once a
   * second otherwise: after 3.5 s without one, the relay reports the page as asleep.
   */
  sendSnapshot(snapshot: Snapshot): void {
    if (this.#connection.waitingBytes > MAX_BUFFERED_BYTES) return;
    this.#send({ type: "snapshot", epoch: this.#epoch, snapshot });
  }

  /** The robot has started a command. */
  started(seq: number): void {
    this.#applied.started(seq);
    this.#outbox.send(() => this.#send({ type: "started", epoch: this.#epoch, seq }));
  }

  /** A command has ended; call it once per command. The ending is sent once the world is stored. */
  ended(seq: number, ending: Omit<Ending, "seq">): void {
    if (this.#isReplaced) return;
    this.#applied.ended(seq);
    const { state, reason, pose, distance } = ending;
    const stored: Ending = { seq, state, reason, pose, distance };
    this.#endings.set(seq, stored);
    const send = (): void => {
      this.#unsaved.delete(seq);
      if (this.#connection.isConnected) this.#sendEnding(stored);
    };
    const saved = this.#options.save?.();
    if (saved !== undefined) this.#unsaved.add(seq);
    this.#outbox.send(send, saved);
  }

  /**
   * Reconnects after `close`, or at once instead of waiting for the next attempt. Does nothing
   * while the connection is open or opening, or after it has ended.
   */
  open(): void {
    if (this.#isReplaced) return;
    // The connection has ignored messages since `close`. The relay sends them again on a new one.
    if (this.#isClosing) this.#connection.close();
    this.#isClosing = false;
    this.#connection.open();
  }

  /**
   * Disconnects until `open`, after all pending endings were sent. The relay reports the robot as
   * gone and retains waiting commands. The connection stores endings until it reconnects.
   */
  close(): void {
    this.#isClosing = true;
    this.#outbox.send(() => {
      if (this.#isClosing) this.#connection.close();
    });
  }

  /**
   * Another page has claimed the stored world, which does not contain the unsent endings: drops
   * them, and disconnects permanently.
   */
  worldClaimed(): void {
    if (this.#isReplaced) return;
    this.#isReplaced = true;
    this.#outbox.clear();
    this.#endings.clear();
    this.#connection.close();
    this.#options.onStatus({ kind: "replaced", reason: closeReasons.replaced });
  }

  #firstMessages(): string[] {
    this.#hasYielded = false;
    this.#applied.returnUnstarted();
    this.#options.onGiveBack();
    this.#transit.helloSent(this.#clock.now());
    const saved = [...this.#endings.values()].filter(({ seq }) => !this.#unsaved.has(seq));
    const endings = saved.slice(0, MAX_RESUMED_ENDINGS);
    this.#resumed = new Set(endings.map(({ seq }) => seq));
    const { ownerKey } = this.#options.credentials;
    const snapshot = this.#options.snapshot();
    return [
      encodeFrame({ type: "hello", version: PROTOCOL_VERSION, role: "own", key: ownerKey }),
      encodeFrame({
        type: "resume",
        lastApplied: this.#applied.last,
        fresh: this.#fresh,
        page: this.#page,
        endings,
        ...(snapshot !== null && { snapshot }),
      }),
    ];
  }

  #received(message: RelayToPage): void {
    // The relay sends unstarted commands again.
    if (this.#isClosing) return;
    switch (message.type) {
      case "welcome":
        this.#transit.answered(message.at, this.#clock.now());
        this.#epoch = message.epoch;
        this.#fresh = false;
        for (const ending of this.#endings.values()) {
          const isSent = this.#resumed.has(ending.seq) || this.#unsaved.has(ending.seq);
          if (!isSent) this.#sendEnding(ending);
        }
        return this.#requestTime();
      case "command": {
        const command = this.#delivered(message);
        if (this.#isNew(command.seq)) this.#options.onCommand(command);
        return;
      }
      case "stop": {
        const stop = this.#delivered(message);
        if (this.#isNew(stop.seq)) this.#stop(stop);
        return;
      }
      case "cancel":
        return this.#options.onCancel(message.seq, message.cause);
      case "stored":
        this.#endings.delete(message.seq);
        return this.#options.onStored?.(message.seq);
      case "refused":
        this.#endings.delete(message.record.seq);
        return this.#options.onRefused(message.record);
      case "state":
        return this.#options.onState(message.record, message.ttl);
      case "drivers": {
        const { type: _type, alive, scripts, paused, mayReset, at, ...drivers } = message;
        const transitMs = this.#transit.transitMs(at, this.#clock.now());
        const now = alive.map(({ driver, silentMs, connectionMs }) => ({
          driver,
          silentMs: silentMs + transitMs,
          connectionMs: connectionMs === null ? null : connectionMs + transitMs,
        }));
        this.#requestTime();
        return this.#options.onDrivers(drivers, now, { scripts, paused, mayReset });
      }
      case "time":
        return this.#transit.answered(message.at, this.#clock.now());
      case "yield":
        return this.#yield();
      case "marks": {
        const { type: _type, ...marks } = message;
        return this.#options.onMarks?.(marks);
      }
      case "heartbeat":
        return;
    }
  }

  /**
   * Releases the robot before another page acquires it. From now on no command starts here: the
   * other page starts the unstarted ones.
   */
  #yield(): void {
    this.#hasYielded = true;
    this.#applied.returnUnstarted();
    this.#options.onGiveBack();
    this.#options.onYield();
    this.#outbox.send(() => {
      // After a reconnect, this page owns the robot again.
      if (this.#hasYielded) this.#send({ type: "yielded", epoch: this.#epoch });
    });
  }

  /**
   * Requests the relay's time if the estimate is imprecise, at most as often as `drivers` arrive.
   */
  #requestTime(): void {
    if (!this.#connection.isConnected || !this.#transit.isImprecise) return;
    this.#transit.timeRequested(this.#clock.now());
    this.#send({ type: "time", epoch: this.#epoch });
  }

  /** The command with its transit time subtracted from the remaining time. */
  #delivered({ type: _type, at, ...command }: DeliveredCommand & { type: string; at: number }) {
    const remaining = command.remaining - this.#transit.transitMs(at, this.#clock.now());
    return { ...command, remaining: Math.max(0, remaining) };
  }

  /** Whether the command is new. Repeats the reports of a known one. */
  #isNew(seq: number): boolean {
    if (this.#hasYielded) return false;
    if (this.#applied.receive(seq)) return true;
    const ending = this.#endings.get(seq);
    if (ending !== undefined) {
      if (!this.#unsaved.has(seq)) this.#sendEnding(ending);
    } else if (seq <= this.#applied.last) this.started(seq);
    return false;
  }

  #stop(stop: DeliveredCommand): void {
    this.#options.onStop(stop);
    this.started(stop.seq);
    const pose = this.#options.snapshot()?.pose ?? null;
    this.ended(stop.seq, { state: "completed", reason: null, pose, distance: 0 });
  }

  /** Sends the current snapshot first, so that readers of the ending never have an older one. */
  #sendEnding(ending: Ending): void {
    const snapshot = this.#options.snapshot();
    if (snapshot !== null) this.#send({ type: "snapshot", epoch: this.#epoch, snapshot });
    this.#send({ type: "ended", epoch: this.#epoch, ...ending });
  }

  #send(message: PageToRelay): void {
    this.#connection.send(encodeFrame(message));
  }
}

function hostStatus(status: ConnectionStatus): HostStatus {
  if (status.kind !== "over") return status;
  return {
    kind: status.reason.code === closeReasons.replaced.code ? "replaced" : "over",
    reason: status.reason,
  };
}
