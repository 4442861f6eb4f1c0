/**
 * The robot at the relay: registers it, maintains the connection, and lists the endings of commands
 * for the Remote panel. The client library loads with the first connection.
 */
import type {
  CommandJournal,
  HostConnection,
  HostConnectionOptions,
  HostStatus,
} from "@corridor/client/host";
import type { MazeDocument } from "@corridor/maze";
import { expiredReason, RELOADED_REASON } from "@corridor/protocol";
import type {
  AliveDriver,
  DeliveredCommand,
  Drivers,
  RecallCause,
  ScriptView,
  Snapshot,
} from "@corridor/protocol";
import { cancelReasons, type CancelReason } from "../protocol/cancel-reason.ts";
import type { Ending, RemoteDriverEvents } from "../drivers/remote-driver.ts";
import { CommandList } from "./command-list.ts";
import { CommandSweep } from "./command-sweep.ts";
import { MazePublisher } from "./maze-publisher.ts";
import { registerWithRetries } from "./register-with-retries.ts";
import type { troubleOf } from "./remote-trouble.ts";
import type {
  ListedCommand,
  ListedScript,
  RemoteSession,
  RemoteStatus,
  RemoteView,
} from "../protocol/worker-messages.ts";

const noDrivers: Drivers = { connected: 0, client: null, silentMs: null };

const recallReasons = {
  sender: "cancelledByScript",
  revoked: "keyRevoked",
  blocked: "blocked",
  paused: "paused",
} as const satisfies Record<RecallCause, CancelReason>;

export interface RemoteHostPorts {
  /** origin of the page and its relay */
  origin: string;
  /** milliseconds since 1970 */
  now(): number;
  /** the current robot; null before it is loaded */
  snapshot(): Snapshot | null;
  onView(view: RemoteView): void;
  onDelivery(delivery: DeliveredCommand): void;
  /** ends all delivered commands, by `ended`, before it returns */
  cancel(reason: CancelReason): void;
  /** ends one command, by `ended`, unless it has ended */
  cancelOne(seq: number, reason: CancelReason): void;
  /** discards delivered commands that have not started */
  reset(): void;
  /** these scripts are alive, so that the leases of their motions are renewed */
  renew(alive: readonly AliveDriver[]): void;
  /** stores the world with `journal` before an ending is sent; see `HostConnectionOptions` */
  save?: NonNullable<HostConnectionOptions["save"]>;
  /** the journal of the restored world, with its robot */
  restored?: () => (CommandJournal & { robot: string }) | null;
  fetch: (
    url: string,
    request: { method: string; headers?: Record<string, string>; body?: string },
  ) => Promise<{ status: number; text(): Promise<string> }>;
  /** scripts draw over the maze */
  onMarks?: NonNullable<HostConnectionOptions["onMarks"]>;
  /** default: the worker's own */
  platform?: NonNullable<HostConnectionOptions["platform"]>;
}

export class RemoteHost implements RemoteDriverEvents {
  readonly #ports: RemoteHostPorts;
  readonly #commands = new CommandList();
  readonly #sweep = new CommandSweep();
  #session: RemoteSession | null = null;
  /**
   * of `#session`; retained while it is closed, because it knows delivered commands and their
   * endings
   */
  #connection: HostConnection | null = null;
  readonly #mazes: MazePublisher;
  #status: RemoteStatus = { kind: "off" };
  #drivers = noDrivers;
  #scripts: ListedScript[] = [];
  #isPaused = false;
  #mayReset = true;
  /** increases with each open and close; results of older attempts are dropped */
  #attempt = 0;

  constructor(ports: RemoteHostPorts) {
    this.#ports = ports;
    this.#mazes = new MazePublisher({
      now: () => performance.now(),
      put: (text) => this.#giveMaze(text),
    });
  }

  /** Endings of commands, to be stored with the world; null without a robot. */
  get journal(): (CommandJournal & { robot: string }) | null {
    const robot = this.#session?.id;
    return robot === undefined || this.#connection === null
      ? null
      : { ...this.#connection.journal, robot };
  }

  /** Whether there is a connection that needs snapshots. */
  get isOpen(): boolean {
    return this.#connection?.isConnected === true;
  }

  /**
   * Opens the connection; without a session a robot is registered first. The current session is
   * reopened, or retried at once; for another one, all delivered commands end first.
   * @param fresh whether no command of the session can still be running, because the page was
   *   reloaded
   */
  open(session: RemoteSession | null, fresh: boolean): void {
    if (this.#connection !== null && session !== null && session.id === this.#session?.id) {
      // The robot may have a new driver key since.
      const { driverKey, address } = session;
      this.#session = { ...this.#session, driverKey, address };
      this.#connection.open();
      return this.#setStatus(this.#status);
    }
    this.#endSession();
    if (session === null || session.id !== this.#session?.id) {
      this.#commands.clear();
      this.#sweep.reset();
    }
    this.#session = session;
    this.#setStatus({ kind: "connecting" });
    const attempt = ++this.#attempt;
    this.#connect(session, fresh, attempt).catch(() => {
      // The client library itself did not load.
      if (attempt === this.#attempt) this.#setStatus({ kind: "lost", reason: "noService" });
    });
  }

  /** Ends all delivered commands and closes the connection; the session can be reopened. */
  close(): void {
    this.#attempt++;
    this.#ports.cancel("disconnected");
    this.#connection?.close();
    this.#drivers = noDrivers;
    this.#scripts = [];
    if (this.#status.kind !== "off") this.#setStatus({ kind: "off" });
  }

  /** Clears the list of commands, except for those that have not ended. */
  clearCommands(): void {
    this.#commands.removeEnded();
    this.#setStatus(this.#status);
  }

  /** @param maze the robot's maze; null if it is not published */
  sendSnapshot(snapshot: Snapshot, maze: MazeDocument | null = null): void {
    this.#connection?.sendSnapshot(snapshot);
    if (this.isOpen) this.#mazes.offer(maze);
  }

  /** Another page has claimed the stored world, and owns the robot from now on. */
  worldClaimed(): void {
    this.#connection?.worldClaimed();
  }

  started(seq: number): void {
    this.#connection?.started(seq);
    this.#change(seq, { state: "started" });
  }

  ended(seq: number, ending: Ending): void {
    this.#sweep.ended(seq, ending.reason);
    this.#connection?.ended(seq, { ...ending, reason: this.#reasonFor(seq, ending) });
    this.#change(seq, ending);
  }

  swept(reason: CancelReason): void {
    this.#sweep.begin(reason, this.#commands.newestSeq);
  }

  async #connect(wanted: RemoteSession | null, fresh: boolean, attempt: number): Promise<void> {
    const [client, trouble] = await Promise.all([
      import("@corridor/client/host"),
      import("./remote-trouble.ts"),
    ]);
    const { origin, platform, save, fetch, onMarks } = this.#ports;
    const isCurrent = (): boolean => attempt === this.#attempt;
    const onStatus = (status: RemoteStatus): void => this.#setStatus(status);
    const session =
      wanted ??
      (await registerWithRetries({ client, origin, fetch, platform, isCurrent, onStatus }));
    if (session === null || !isCurrent()) return;
    this.#session = session;
    this.#mazes.begin();
    const restored = fresh ? (this.#ports.restored?.() ?? null) : null;
    const journal =
      restored?.robot === session.id
        ? restored
        : { lastApplied: 0, endings: fresh ? this.#endedByReload(session) : [] };
    this.#connection = new client.HostConnection({
      origin,
      credentials: session,
      // Commands that started after the world was last stored cannot be running either.
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
      onCancel: (seq, why) => this.#ports.cancelOne(seq, recallReasons[why]),
      onGiveBack: () => this.#reset(),
      onYield: () => this.#ports.cancel("addressEnded"),
      onState: (record, ttl) => {
        this.#sweep.queued(record.seq);
        this.#show({ ...record, ttl, reason: null });
      },
      onRefused: ({ seq, state }) => {
        this.#sweep.confirmed(seq);
        this.#change(seq, { state, reason: null });
      },
      onStored: (seq) => this.#sweep.confirmed(seq),
      onStatus: (status) => this.#linkChanged(status, trouble.troubleOf),
      onDrivers: (drivers, alive, { scripts, paused, mayReset }) => {
        this.#drivers = drivers;
        this.#isPaused = paused;
        this.#mayReset = mayReset;
        this.#scripts = scripts.map((script) => this.#listed(script));
        this.#ports.renew(alive);
        if (this.isOpen) this.#setStatus(this.#connectedStatus());
      },
      ...(onMarks === undefined ? {} : { onMarks }),
      ...(platform === undefined ? {} : { platform }),
    });
  }

  /** The reload started a new world, in which the last started command never continues. */
  #endedByReload({ lastApplied: seq }: RemoteSession): CommandJournal["endings"] {
    if (seq === 0) return [];
    const pose = this.#ports.snapshot()?.pose ?? null;
    return [{ seq, state: "cancelled", reason: RELOADED_REASON, pose, distance: 0 }];
  }

  /** For viewers: snapshots do not contain the maze. */
  async #giveMaze(text: string): Promise<number> {
    const { origin, fetch } = this.#ports;
    const { id = "", ownerKey = "" } = this.#session ?? {};
    const headers = { Authorization: `Bearer ${ownerKey}`, "Content-Type": "application/json" };
    const request = { method: "PUT", headers, body: text };
    return (await fetch(`${origin}/api/v1/robots/${id}/maze`, request)).status;
  }

  /** Ends a session: nothing of it may run on, or be reported under the next session's numbers. */
  #endSession(): void {
    if (this.#connection === null) return;
    this.#ports.cancel("addressEnded");
    this.#connection.close();
    this.#connection = null;
    this.#drivers = noDrivers;
    this.#scripts = [];
  }

  #deliver(command: DeliveredCommand): void {
    this.#list(command);
    const reason = this.#sweep.reasonFor(command.seq);
    const pose = this.#ports.snapshot()?.pose;
    if (reason !== null && pose !== undefined) {
      return this.ended(command.seq, { state: "cancelled", reason, pose, distance: 0 });
    }
    this.#ports.onDelivery(command);
  }

  /** Commands queued here may end at the relay before they are delivered again. */
  #reset(): void {
    this.#ports.reset();
    this.#commands.returnDelivered();
  }

  /** Why a command ended early, for scripts. */
  #reasonFor(seq: number, { state, reason }: Ending): string | null {
    if (reason !== null) return cancelReasons[reason];
    const record = this.#commands.get(seq);
    if (state !== "expired" || record === undefined) return null;
    const isPaused = this.#ports.snapshot()?.state === "paused";
    return expiredReason(record.ttl, isPaused ? "paused" : undefined);
  }

  #list(command: DeliveredCommand): void {
    this.#commands.deliver(command);
    this.#setStatus(this.#status);
  }

  #show(record: ListedCommand): void {
    this.#commands.set(record);
    this.#setStatus(this.#status);
  }

  #change(seq: number, change: Partial<ListedCommand>): void {
    this.#commands.change(seq, change);
    if (this.#session !== null && this.#connection !== null) {
      this.#session = { ...this.#session, lastApplied: this.#connection.lastApplied };
    }
    this.#setStatus(this.#status);
  }

  #linkChanged(status: HostStatus, nameOf: typeof troubleOf): void {
    switch (status.kind) {
      case "connecting":
        return this.#setStatus({ kind: "connecting" });
      case "connected":
        return this.#setStatus(this.#connectedStatus());
      case "lost":
        return this.#setStatus({ kind: "lost", reason: nameOf(status.reason) });
      case "over":
      case "replaced":
        this.#endSession();
        return this.#setStatus({ kind: "over", reason: nameOf(status.reason) });
    }
  }

  /**
   * Waiting until the first message of a script; then its name and the time of its last message.
   */
  #connectedStatus(): RemoteStatus {
    const { client, silentMs } = this.#drivers;
    if (silentMs === null) return { kind: "waiting" };
    return { kind: "connected", client: client ?? "", seenAt: this.#ports.now() - silentMs };
  }

  #listed({ silentMs, ...script }: ScriptView): ListedScript {
    return { ...script, seenAt: silentMs === null ? null : this.#ports.now() - silentMs };
  }

  #setStatus(status: RemoteStatus): void {
    this.#status = status;
    this.#ports.onView({
      status,
      session: this.#session,
      scripts: this.#scripts,
      isPaused: this.#isPaused,
      mayReset: this.#mayReset,
      commands: this.#commands.toArray(),
    });
  }
}
