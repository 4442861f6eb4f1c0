/**
 * The robot as the relay knows it: registers it, keeps the link, and remembers what became of each
 * command for the Remote panel. The client library comes with the first connection; who never drives
 * by script never loads it.
 */
import type { HostLink, HostStatus } from "@corridor/client/host";
import type { CommandRecord, DeliveredCommand, Drivers, Snapshot } from "@corridor/protocol";
import type { Delivery, Ending, RemoteDriverEvents } from "../drivers/remote-driver.ts";
import type { RemoteSession, RemoteStatus, RemoteView } from "./worker-messages.ts";

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
  onDelivery(delivery: Delivery): void;
  /** ends all that was delivered before this returns */
  onStop(): void;
}

export class RemoteHost implements RemoteDriverEvents {
  readonly #ports: RemoteHostPorts;
  /** newest last, by seq */
  readonly #commands = new Map<number, CommandRecord>();
  #session: RemoteSession | null = null;
  #link: HostLink | null = null;
  #status: RemoteStatus = { kind: "off" };
  #drivers: Drivers = { connected: 0, client: null, silentMs: null };
  /** rises with each open and close: what an older one still waits for is dropped */
  #attempt = 0;

  constructor(ports: RemoteHostPorts) {
    this.#ports = ports;
  }

  /** Whether there is a link that wants snapshots. */
  get isOpen(): boolean {
    return this.#link?.isConnected === true;
  }

  /** Opens the link; without a session a robot is registered first. */
  open(session: RemoteSession | null, fresh: boolean): void {
    this.close();
    this.#session = session;
    this.#tell({ kind: "connecting" });
    const attempt = this.#attempt;
    this.#connect(session, fresh, attempt).catch((error: unknown) => {
      if (attempt !== this.#attempt) return;
      const reason = error instanceof Error ? error.message : "The service does not answer.";
      this.#tell({ kind: "lost", reason });
    });
  }

  close(): void {
    this.#attempt++;
    this.#link?.close();
    this.#link = null;
    this.#drivers = { connected: 0, client: null, silentMs: null };
    if (this.#status.kind !== "off") this.#tell({ kind: "off" });
  }

  /** Empties the list of commands; those that still live stay. */
  clearCommands(): void {
    for (const [seq, { state }] of this.#commands) {
      if (state !== "delivered" && state !== "started") this.#commands.delete(seq);
    }
    this.#tell(this.#status);
  }

  sendSnapshot(snapshot: Snapshot): void {
    this.#link?.sendSnapshot(snapshot);
  }

  started(seq: number): void {
    this.#link?.started(seq);
    this.#change(seq, { state: "started" });
  }

  ended(seq: number, ending: Ending): void {
    this.#link?.ended(seq, ending);
    this.#change(seq, ending);
  }

  async #connect(wanted: RemoteSession | null, fresh: boolean, attempt: number): Promise<void> {
    const { HostLink: Link, registerRobot } = await import("@corridor/client/host");
    const { origin } = this.#ports;
    const session = wanted ?? {
      ...(await registerRobot(origin, (url, request) => fetch(url, request))),
      lastApplied: 0,
    };
    if (attempt !== this.#attempt) return;
    this.#session = session;
    this.#link = new Link({
      origin,
      credentials: session,
      lastApplied: session.lastApplied,
      fresh,
      snapshot: () => this.#ports.snapshot(),
      onCommand: (command) => this.#deliver(command),
      onStop: (stop) => {
        this.#list(stop);
        this.#ports.onStop();
        this.#change(stop.seq, { state: "completed" });
      },
      onStatus: (status) => this.#linkChanged(status),
      onDrivers: (drivers) => {
        this.#drivers = drivers;
        if (this.isOpen) this.#tell(this.#connectedStatus());
      },
    });
  }

  #deliver(command: DeliveredCommand): void {
    this.#list(command);
    this.#ports.onDelivery(command);
  }

  #list({ seq, key, command, acceptedAt }: DeliveredCommand): void {
    this.#commands.set(seq, {
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
    });
    const oldest = this.#commands.keys().next().value;
    if (this.#commands.size > MAX_LISTED && oldest !== undefined) this.#commands.delete(oldest);
    this.#tell(this.#status);
  }

  #change(seq: number, change: Partial<CommandRecord>): void {
    const record = this.#commands.get(seq);
    if (record !== undefined) this.#commands.set(seq, { ...record, ...change });
    if (this.#session !== null && this.#link !== null) {
      this.#session = { ...this.#session, lastApplied: this.#link.lastApplied };
    }
    this.#tell(this.#status);
  }

  #linkChanged(status: HostStatus): void {
    switch (status.kind) {
      case "connecting":
        return this.#tell({ kind: "connecting" });
      case "connected":
        return this.#tell(this.#connectedStatus());
      case "lost":
        return this.#tell({ kind: "lost", reason: sentence(status.reason) });
      case "over":
      case "replaced":
        return this.#tell({ kind: "over", reason: sentence(status.reason) });
    }
  }

  /** Waiting until a script was heard; then who it is and when it was heard last. */
  #connectedStatus(): RemoteStatus {
    const { client, silentMs } = this.#drivers;
    if (silentMs === null) return { kind: "waiting" };
    return { kind: "connected", client: client ?? "", heardAt: this.#ports.now() - silentMs };
  }

  #tell(status: RemoteStatus): void {
    this.#status = status;
    this.#ports.onView({
      status,
      session: this.#session,
      commands: [...this.#commands.values()].toReversed(),
    });
  }
}

/** A close reason as a sentence: what happened, and what helps. */
function sentence({ cause, remedy }: { cause: string; remedy: string }): string {
  return `${cause.slice(0, 1).toUpperCase()}${cause.slice(1)}. ${remedy}`;
}
