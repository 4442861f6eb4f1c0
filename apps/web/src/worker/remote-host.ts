/**
 * The robot as the relay knows it: registers it, keeps the link, and remembers what became of each
 * command for the Remote panel. The client library comes with the first connection; who never drives
 * by script never loads it.
 */
import type * as ClientLibrary from "@corridor/client/host";
import type { CommandJournal, HostLink, HostLinkOptions, HostStatus } from "@corridor/client/host";
import type { MazeDocument } from "@corridor/maze";
import { expiredReason } from "@corridor/protocol";
import type {
  AliveDriver,
  CommandRecord,
  DeliveredCommand,
  Drivers,
  RecallCause,
  ScriptView,
  Snapshot,
} from "@corridor/protocol";
import {
  cancelReasons,
  RELOADED,
  pageReasons,
  type CancelReason,
} from "../drivers/cancel-reason.ts";
import type { Ending, RemoteDriverEvents } from "../drivers/remote-driver.ts";
import { MazeTeller } from "./maze-teller.ts";
import type { troubleOf } from "./remote-trouble.ts";
import type {
  ListedCommand,
  ListedScript,
  RemoteSession,
  RemoteStatus,
  RemoteView,
} from "./worker-messages.ts";

const noDrivers: Drivers = { connected: 0, client: null, silentMs: null };

const recallReasons = {
  sender: "takenBack",
  revoked: "keyRevoked",
  blocked: "blocked",
  paused: "paused",
} as const satisfies Record<RecallCause, CancelReason>;

/** Commands that the panel lists. */
const MAX_LISTED = 100;

export interface RemoteHostPorts {
  /** of the page and its relay */
  origin: string;
  /** milliseconds since 1970 */
  now(): number;
  /** the robot as it is now; null before it is loaded */
  snapshot(): Snapshot | null;
  onView(view: RemoteView): void;
  onDelivery(delivery: DeliveredCommand): void;
  /** ends all that was delivered, by `ended`, before this returns */
  cancel(reason: CancelReason): void;
  /** ends one command, by `ended`, unless it has ended */
  takeBack(seq: number, reason: CancelReason): void;
  /** forgets what was delivered and has not started */
  giveBack(): void;
  /** scripts were heard, and may go on with the motions that they wished */
  hear(alive: readonly AliveDriver[]): void;
  /** stores the world with `journal` before an ending is sent; see `HostLinkOptions` */
  save?: NonNullable<HostLinkOptions["save"]>;
  /** the journal of the world that was restored, and the robot that it is of */
  restored?: () => (CommandJournal & { robot: string }) | null;
  fetch: (
    url: string,
    request: { method: string; headers?: Record<string, string>; body?: string },
  ) => Promise<{ status: number; text(): Promise<string> }>;
  /** default: what the worker offers */
  platform?: NonNullable<HostLinkOptions["platform"]>;
}

export class RemoteHost implements RemoteDriverEvents {
  readonly #ports: RemoteHostPorts;
  /** by seq */
  readonly #commands = new Map<number, ListedCommand>();
  #session: RemoteSession | null = null;
  /** of `#session`; kept while it is closed, since it knows what was handed on and how it ended */
  #link: HostLink | null = null;
  readonly #mazes: MazeTeller;
  #status: RemoteStatus = { kind: "off" };
  #drivers = noDrivers;
  #scripts: ListedScript[] = [];
  #isPaused = false;
  /** the page took the robot: what had been sent by then never runs, even where it comes only now */
  #swept: { upTo: number; reason: CancelReason } | null = null;
  /** the first command that was ended so, until the relay knows: what is told before had been sent by then too */
  #sweeping: number | null = null;
  /** rises with each open and close: what an older one still waits for is dropped */
  #attempt = 0;

  constructor(ports: RemoteHostPorts) {
    this.#ports = ports;
    this.#mazes = new MazeTeller({
      now: () => performance.now(),
      give: (text) => this.#giveMaze(text),
    });
  }

  /** How commands have ended, to be stored with the world; null without a robot. */
  get journal(): (CommandJournal & { robot: string }) | null {
    const robot = this.#session?.id;
    return robot === undefined || this.#link === null ? null : { ...this.#link.journal, robot };
  }

  /** Whether there is a link that wants snapshots. */
  get isOpen(): boolean {
    return this.#link?.isConnected === true;
  }

  /**
   * Opens the link; without a session a robot is registered first. The session that is there is
   * opened again, or tried again at once; for another one, all that the robot was given ends first.
   * @param fresh whether a session's commands cannot be running any more: the page was loaded anew
   */
  open(session: RemoteSession | null, fresh: boolean): void {
    if (this.#link !== null && session !== null && session.id === this.#session?.id) {
      // The robot may have a new key for scripts meanwhile.
      const { driverKey, address } = session;
      this.#session = { ...this.#session, driverKey, address };
      this.#link.open();
      return this.#tell(this.#status);
    }
    this.#leave();
    if (session === null || session.id !== this.#session?.id) {
      this.#commands.clear();
      this.#swept = null;
      this.#sweeping = null;
    }
    this.#session = session;
    this.#tell({ kind: "connecting" });
    const attempt = ++this.#attempt;
    this.#connect(session, fresh, attempt).catch(() => {
      // The client library itself did not come.
      if (attempt === this.#attempt) this.#tell({ kind: "lost", reason: "noService" });
    });
  }

  /** Ends all that the robot was given and closes the link; the session can be opened again. */
  close(): void {
    this.#attempt++;
    this.#ports.cancel("disconnected");
    this.#link?.close();
    this.#drivers = noDrivers;
    this.#scripts = [];
    if (this.#status.kind !== "off") this.#tell({ kind: "off" });
  }

  /** Empties the list of commands; those that still live stay. */
  clearCommands(): void {
    for (const [seq, { state }] of this.#commands) {
      if (isEnding(state)) this.#commands.delete(seq);
    }
    this.#tell(this.#status);
  }

  /** @param maze that the robot is in; null where that is told to nobody */
  sendSnapshot(snapshot: Snapshot, maze: MazeDocument | null = null): void {
    this.#link?.sendSnapshot(snapshot);
    if (this.isOpen) this.#mazes.offer(maze);
  }

  /** Another page has claimed the stored world, and is the robot from now on. */
  worldClaimed(): void {
    this.#link?.worldClaimed();
  }

  started(seq: number): void {
    this.#link?.started(seq);
    this.#change(seq, { state: "started" });
  }

  ended(seq: number, ending: Ending): void {
    if (ending.reason !== null && pageReasons.has(ending.reason)) this.#sweeping ??= seq;
    this.#link?.ended(seq, { ...ending, reason: this.#reasonFor(seq, ending) });
    this.#change(seq, ending);
  }

  swept(reason: CancelReason): void {
    if (!pageReasons.has(reason)) return;
    this.#swept = { upTo: Math.max(0, ...this.#commands.keys()), reason };
  }

  async #connect(wanted: RemoteSession | null, fresh: boolean, attempt: number): Promise<void> {
    const [client, trouble] = await Promise.all([
      import("@corridor/client/host"),
      import("./remote-trouble.ts"),
    ]);
    const { origin, platform, save } = this.#ports;
    const session = wanted ?? (await this.#register(client, attempt));
    if (session === null || attempt !== this.#attempt) return;
    this.#session = session;
    this.#mazes.begin();
    const restored = fresh ? (this.#ports.restored?.() ?? null) : null;
    const journal =
      restored?.robot === session.id
        ? restored
        : { lastApplied: 0, endings: fresh ? this.#endedByReload(session) : [] };
    this.#link = new client.HostLink({
      origin,
      credentials: session,
      // What was begun after the world was stored last cannot be running either.
      lastApplied: Math.max(session.lastApplied, journal.lastApplied),
      endings: journal.endings,
      fresh,
      ...(save === undefined ? {} : { save }),
      snapshot: () => this.#ports.snapshot(),
      onCommand: (command) => this.#deliver(command),
      onStop: (stop) => {
        this.#list(stop);
        this.#ports.cancel("stopped");
        this.#change(stop.seq, { state: "completed" });
      },
      onCancel: (seq, why) => this.#ports.takeBack(seq, recallReasons[why]),
      onGiveBack: () => this.#giveBack(),
      onYield: () => this.#ports.cancel("addressEnded"),
      onState: (record, ttl) => {
        this.#sweepOn(record.seq);
        this.#show({ ...record, ttl, reason: null });
      },
      onRefused: ({ seq, state }) => {
        this.#sweptUntil(seq);
        this.#change(seq, { state, reason: null });
      },
      onStored: (seq) => this.#sweptUntil(seq),
      onStatus: (status) => this.#linkChanged(status, trouble.troubleOf),
      onDrivers: (drivers, alive, { scripts, paused }) => {
        this.#drivers = drivers;
        this.#isPaused = paused;
        this.#scripts = scripts.map((script) => this.#listed(script));
        this.#ports.hear(alive);
        if (this.isOpen) this.#tell(this.#connectedStatus());
      },
      ...(platform === undefined ? {} : { platform }),
    });
  }

  /** The reload began a new world, in which the command that was started last never goes on. */
  #endedByReload({ lastApplied: seq }: RemoteSession): CommandJournal["endings"] {
    if (seq === 0) return [];
    const pose = this.#ports.snapshot()?.pose ?? null;
    return [{ seq, state: "cancelled", reason: RELOADED, pose, distance: 0 }];
  }

  /**
   * Registers a robot. Where nothing answers it tries again by itself, as the link does: a device says that it
   * has a network before requests get through.
   * @returns null where the service has no robot for this page, or another attempt began
   */
  async #register(client: typeof ClientLibrary, attempt: number): Promise<RemoteSession | null> {
    const { origin, fetch, platform } = this.#ports;
    const { clock, random } = platform ?? client.globalPlatform();
    const backoff = new client.Backoff();
    while (attempt === this.#attempt) {
      try {
        return { ...(await client.registerRobot(origin, fetch)), lastApplied: 0 };
      } catch (error) {
        if (attempt !== this.#attempt) break;
        const reason = error instanceof client.RegistrationError ? error.code : "noService";
        if (reason !== "noAnswer") {
          this.#tell({ kind: "lost", reason });
          break;
        }
      }
      this.#tell({ kind: "lost", reason: "lineLost" });
      const pause = Promise.withResolvers<void>();
      clock.after(backoff.next(clock.now(), random()), pause.resolve);
      await pause.promise;
      if (attempt === this.#attempt) this.#tell({ kind: "connecting" });
    }
    return null;
  }

  /** A command waits at the relay: was it sent before the page took the robot? */
  #sweepOn(seq: number): void {
    if (this.#sweeping === null || this.#swept === null) return;
    this.#swept.upTo = Math.max(this.#swept.upTo, seq);
  }

  /** The relay knows that this one has ended. */
  #sweptUntil(seq: number): void {
    if (seq === this.#sweeping) this.#sweeping = null;
  }

  /** For those who look on: the robot's snapshots do not say among which walls it is. */
  async #giveMaze(text: string): Promise<number> {
    const { origin, fetch } = this.#ports;
    const { id = "", ownerKey = "" } = this.#session ?? {};
    const headers = { Authorization: `Bearer ${ownerKey}`, "Content-Type": "application/json" };
    const request = { method: "PUT", headers, body: text };
    return (await fetch(`${origin}/api/v1/robots/${id}/maze`, request)).status;
  }

  /** Parts with a session: nothing of it may run on, or be told under the next one's numbers. */
  #leave(): void {
    if (this.#link === null) return;
    this.#ports.cancel("addressEnded");
    this.#link.close();
    this.#link = null;
    this.#drivers = noDrivers;
    this.#scripts = [];
  }

  #deliver(command: DeliveredCommand): void {
    this.#list(command);
    const pose = this.#ports.snapshot()?.pose;
    if (this.#swept !== null && command.seq <= this.#swept.upTo && pose !== undefined) {
      const { reason } = this.#swept;
      return this.ended(command.seq, { state: "cancelled", reason, pose, distance: 0 });
    }
    this.#ports.onDelivery(command);
  }

  /** What waits here may end at the relay before it comes again. */
  #giveBack(): void {
    this.#ports.giveBack();
    for (const [seq, record] of this.#commands) {
      if (record.state === "delivered") this.#commands.set(seq, { ...record, state: "accepted" });
    }
  }

  /** Why a command ended early, for scripts. */
  #reasonFor(seq: number, { state, reason }: Ending): string | null {
    if (reason !== null) return cancelReasons[reason];
    const record = this.#commands.get(seq);
    return state === "expired" && record !== undefined ? expiredReason(record.ttl) : null;
  }

  #list({ seq, key, command, acceptedAt, ttl }: DeliveredCommand): void {
    this.#show({
      seq,
      key,
      action: command.action,
      command,
      state: "delivered",
      reason: null,
      acceptedAt,
      pose: null,
      distance: null,
      duplicate: false,
      ttl,
    });
  }

  #show(record: ListedCommand): void {
    this.#commands.set(record.seq, record);
    if (this.#commands.size > MAX_LISTED) this.#commands.delete(Math.min(...this.#commands.keys()));
    this.#tell(this.#status);
  }

  #change(seq: number, change: Partial<ListedCommand>): void {
    const record = this.#commands.get(seq);
    if (record !== undefined) this.#commands.set(seq, { ...record, ...change });
    if (this.#session !== null && this.#link !== null) {
      this.#session = { ...this.#session, lastApplied: this.#link.lastApplied };
    }
    this.#tell(this.#status);
  }

  #linkChanged(status: HostStatus, nameOf: typeof troubleOf): void {
    switch (status.kind) {
      case "connecting":
        return this.#tell({ kind: "connecting" });
      case "connected":
        return this.#tell(this.#connectedStatus());
      case "lost":
        return this.#tell({ kind: "lost", reason: nameOf(status.reason) });
      case "over":
      case "replaced":
        this.#leave();
        return this.#tell({ kind: "over", reason: nameOf(status.reason) });
    }
  }

  /** Waiting until a script was heard; then who it is and when it was heard last. */
  #connectedStatus(): RemoteStatus {
    const { client, silentMs } = this.#drivers;
    if (silentMs === null) return { kind: "waiting" };
    return { kind: "connected", client: client ?? "", heardAt: this.#ports.now() - silentMs };
  }

  #listed({ silentMs, ...script }: ScriptView): ListedScript {
    return { ...script, heardAt: silentMs === null ? null : this.#ports.now() - silentMs };
  }

  #tell(status: RemoteStatus): void {
    this.#status = status;
    this.#ports.onView({
      status,
      session: this.#session,
      scripts: this.#scripts,
      isPaused: this.#isPaused,
      commands: [...this.#commands.values()].toSorted((a, b) => b.seq - a.seq),
    });
  }
}

function isEnding(state: CommandRecord["state"]): boolean {
  return state !== "accepted" && state !== "delivered" && state !== "started";
}
