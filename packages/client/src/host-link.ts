/**
 * The robot's side of the line: the page that owns a robot takes commands and reports what becomes
 * of them. It can run in a worker.
 *
 * Whatever ended is kept until the relay says that it is stored, across any number of lost lines, so
 * that each command has exactly one ending. What has begun is never handed on again: the relay may
 * repeat itself, the robot may not. What has not begun goes back to the relay with each new line, for
 * the relay may have ended it meanwhile. All of it holds over `close` and `open` too, so one session
 * needs one link for as long as its page lives.
 */
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
import { doorUrls } from "./robot-address.ts";
import { TransitClock } from "./transit-clock.ts";

/** A snapshot is left out while so many bytes wait: a newer one will do. */
const CROWDED_BYTES = 64 * 1024;

export type HostStatus =
  | { kind: "connecting" }
  | { kind: "connected" }
  /** the link tries again by itself after `retryMs` */
  | { kind: "lost"; reason: CloseReason; retryMs: number }
  /** the session is gone: register again */
  | { kind: "over"; reason: CloseReason }
  /** another page took the robot */
  | { kind: "replaced"; reason: CloseReason };

/** What a page stores of its commands together with its world, for the page after a reload. */
export interface CommandJournal {
  lastApplied: number;
  /** endings of which it is not known that the relay has stored them, oldest first */
  endings: Ending[];
}

export interface HostLinkOptions {
  /** of the service, such as https://robots.example.org */
  origin: string;
  credentials: { id: string; ownerKey: string };
  /** highest seq that this page has ever started or ended; 0 when none */
  lastApplied: number;
  /** endings in the restored world that the relay may not have stored; default: none */
  endings?: readonly Ending[];
  /**
   * Stores the world together with `journal`. An ending is sent once this resolves: the world is stored, or no
   * reload restores it. Where another page has claimed the world, call `worldClaimed` first.
   */
  save?(): Promise<void>;
  /** true when the page was loaded anew and no longer runs what it had started */
  fresh: boolean;
  /** The robot as it is now: sent before all endings, so that who waits for one reads fresh sensors. */
  snapshot(): Snapshot | null;
  /** A new command. Commands come in the order of their seq; start them in that order. */
  onCommand(command: DeliveredCommand): void;
  /** End all that was handed on, by `ended`, before this returns. The stop itself ends by itself. */
  onStop(stop: DeliveredCommand): void;
  /** Somebody wishes that a command ends: end it, by `ended`, unless it has ended already. */
  onCancel(seq: number, cause: RecallCause): void;
  /** Forget all that was handed on and has not begun: what still holds comes again. */
  onGiveBack(): void;
  /** Another page is about to take the robot: end what runs, by `ended`, before this returns. */
  onYield(): void;
  /** A command that this robot does not hold: it waits at the relay, or has ended there. */
  onState(record: CommandRecord, ttl: number): void;
  /** The ending that was told came too late: this is how the command has ended. */
  onRefused(record: CommandRecord): void;
  /**
   * The ending that was told counts. What waited at the relay before it knew of one that is `cancelled` was told
   * by `onState` before this.
   */
  onStored?(seq: number): void;
  onStatus(status: HostStatus): void;
  /**
   * Scripts came, went or were heard; about once a second.
   * @param alive whose motions without an end may go on: 3 s after a script was heard last they stop
   * @param owned the same by name with those that were sent away, and whether remote driving is paused
   */
  onDrivers(drivers: Drivers, alive: readonly AliveDriver[], owned: ScriptList): void;
  /** default: what browsers, workers and Node offer */
  platform?: Omit<Platform, "uniqueText">;
}

export class HostLink {
  readonly #options: HostLinkOptions;
  readonly #connection: Connection<RelayToPage>;
  /** endings that the relay is not known to have stored, by seq, oldest first */
  readonly #endings = new Map<number, Ending>();
  /** those of them that wait for `save` */
  readonly #unsaved = new Set<number>();
  readonly #outbox = new Outbox();
  /** `close` was called, and endings before it are being saved */
  #isClosing = false;
  /** another page has this page's world */
  #isReplaced = false;
  /** endings that the newest greeting carried */
  #resumed = new Set<number>();
  #epoch = 1;
  /** by which the relay knows this page on each of its lines */
  readonly #page: string;
  /** it has left the robot to another page, and begins nothing that may still come on this line */
  #hasYielded = false;
  #fresh: boolean;
  readonly #clock: Platform["clock"];
  readonly #transit = new TransitClock();
  readonly #applied: AppliedCommands;

  /** Opens the link at once. */
  constructor(options: HostLinkOptions) {
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
      urls: doorUrls(origin, credentials.id),
      platform,
      greeting: () => this.#greeting(),
      decode: (text) => decodeFrame(relayToPageSchema, text),
      received: (message) => this.#received(message),
      changed: (status) => options.onStatus(hostStatus(status)),
    });
    this.#connection.open();
  }

  /** This command and all before it have begun or ended; keep it with the credentials for a reload. */
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
   * Reports the robot. Call it up to 20 times a second while it moves, and at least once a second
   * while it stands or is paused: silence of 3.5 s counts as a page that sleeps.
   */
  sendSnapshot(snapshot: Snapshot): void {
    if (this.#connection.waitingBytes > CROWDED_BYTES) return;
    this.#send({ type: "snapshot", epoch: this.#epoch, snapshot });
  }

  /** The robot has begun with a command. */
  started(seq: number): void {
    this.#applied.begun(seq);
    this.#outbox.send(() => this.#send({ type: "started", epoch: this.#epoch, seq }));
  }

  /** A command is over: its one and only ending. It is sent once the world that it leaves is stored. */
  ended(seq: number, ending: Omit<Ending, "seq">): void {
    if (this.#isReplaced) return;
    this.#applied.ended(seq);
    const { state, reason, pose, distance } = ending;
    const kept: Ending = { seq, state, reason, pose, distance };
    this.#endings.set(seq, kept);
    const tell = (): void => {
      this.#unsaved.delete(seq);
      if (this.#connection.isConnected) this.#tellEnding(kept);
    };
    const saved = this.#options.save?.();
    if (saved !== undefined) this.#unsaved.add(seq);
    this.#outbox.send(tell, saved);
  }

  /**
   * Opens the link again after `close`, or at once where it waits to try again; does nothing while it
   * is open or being opened, and once it is over.
   */
  open(): void {
    if (this.#isReplaced) return;
    this.#isClosing = false;
    this.#connection.open();
  }

  /**
   * Leaves the relay until `open`, after the endings so far. Scripts are told that the robot is gone; what waits
   * there goes on waiting, and endings that come meanwhile are kept.
   */
  close(): void {
    this.#isClosing = true;
    this.#outbox.send(() => {
      if (this.#isClosing) this.#connection.close();
    });
  }

  /**
   * Another page has claimed the stored world, in which the endings that are not sent yet never happened: drops
   * them, and leaves the robot to that page for good.
   */
  worldClaimed(): void {
    if (this.#isReplaced) return;
    this.#isReplaced = true;
    this.#outbox.clear();
    this.#endings.clear();
    this.#connection.close();
    this.#options.onStatus({ kind: "replaced", reason: closeReasons.replaced });
  }

  #greeting(): string[] {
    this.#hasYielded = false;
    this.#applied.giveBack();
    this.#options.onGiveBack();
    this.#transit.greeted(this.#clock.now());
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
    // What is delivered now counts as not begun, and comes again.
    if (this.#isClosing) return;
    switch (message.type) {
      case "welcome":
        this.#transit.answered(message.at, this.#clock.now());
        this.#epoch = message.epoch;
        this.#fresh = false;
        for (const ending of this.#endings.values()) {
          const isTold = this.#resumed.has(ending.seq) || this.#unsaved.has(ending.seq);
          if (!isTold) this.#tellEnding(ending);
        }
        return this.#askTime();
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
        const { type: _type, alive, scripts, paused, at, ...drivers } = message;
        const waited = this.#transit.came(at, this.#clock.now());
        const now = alive.map(({ driver, silentMs, connectionMs }) => ({
          driver,
          silentMs: silentMs + waited,
          connectionMs: connectionMs === null ? null : connectionMs + waited,
        }));
        this.#askTime();
        return this.#options.onDrivers(drivers, now, { scripts, paused });
      }
      case "time":
        return this.#transit.answered(message.at, this.#clock.now());
      case "yield":
        return this.#yield();
      case "heartbeat":
        return;
    }
  }

  /**
   * Gives the robot up before another page gets it. What has not begun is that one's to begin, so from here
   * on nothing does.
   */
  #yield(): void {
    this.#hasYielded = true;
    this.#applied.giveBack();
    this.#options.onGiveBack();
    this.#options.onYield();
    this.#outbox.send(() => {
      // On a new connection it has the robot again.
      if (this.#hasYielded) this.#send({ type: "yielded", epoch: this.#epoch });
    });
  }

  /** Asks for the relay's time where it is not known well, about as often as it tells of scripts. */
  #askTime(): void {
    if (!this.#connection.isConnected || !this.#transit.isVague) return;
    this.#transit.asked(this.#clock.now());
    this.#send({ type: "time", epoch: this.#epoch });
  }

  /** A command as it is now: what was held up on the way has less time left. */
  #delivered({ type: _type, at, ...command }: DeliveredCommand & { type: string; at: number }) {
    const remaining = command.remaining - this.#transit.came(at, this.#clock.now());
    return { ...command, remaining: Math.max(0, remaining) };
  }

  /** Whether the command is handed on for the first time; a repeated one is answered from memory. */
  #isNew(seq: number): boolean {
    if (this.#hasYielded) return false;
    if (this.#applied.take(seq)) return true;
    const ending = this.#endings.get(seq);
    if (ending !== undefined) {
      if (!this.#unsaved.has(seq)) this.#tellEnding(ending);
    } else if (seq <= this.#applied.last) this.started(seq);
    return false;
  }

  #stop(stop: DeliveredCommand): void {
    this.#options.onStop(stop);
    this.started(stop.seq);
    const pose = this.#options.snapshot()?.pose ?? null;
    this.ended(stop.seq, { state: "completed", reason: null, pose, distance: 0 });
  }

  /** An ending, after the robot as it is now: who hears of the one must not read an older other. */
  #tellEnding(ending: Ending): void {
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
