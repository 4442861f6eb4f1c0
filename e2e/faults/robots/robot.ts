/** A robot of a scenario: its registration, its current page, and the history of its commands. */
import { hasEnded, type CommandRecord, type Registration } from "@corridor/protocol";
import { History, type Fault } from "../../../apps/relay/src/testing/faults/history.ts";
import type {
  RemoteSession,
  RemoteStatus,
} from "../../../apps/web/src/simulator/protocol/worker-messages.ts";
import { machineNow, sleep, wallClock } from "../clock.ts";
import type { FromPages } from "./page-messages.ts";

/** ms after its time to live within which a command may still start */
const TOLERANCE_MS = 100;
const POLL_MS = 500;

export class Robot {
  readonly registration: Registration;
  readonly history = new History(TOLERANCE_MS, wallClock);
  /** session that the tab stores */
  session: RemoteSession;
  /** number of the newest page */
  page = 0;
  status: RemoteStatus = { kind: "off" };
  isMoving = false;
  movedAt = 0;
  /** time at which the relay last assigned the robot to the newest page */
  acquiredAt = 0;
  /** times at which the page last connected and disconnected */
  connectedAt = 0;
  disconnectedAt = 0;
  /** start times of commands, newest last */
  readonly starts: { seq: number; at: number }[] = [];
  /** pages that were notified of their replacement by another page */
  readonly replacedPages = new Set<number>();

  constructor(registration: Registration) {
    this.registration = registration;
    this.session = { ...registration, lastApplied: 0 };
  }

  get isConnected(): boolean {
    return this.status.kind === "waiting" || this.status.kind === "connected";
  }

  /** Processes a message of one of its pages. */
  receive(message: Exclude<FromPages, { type: "ready" }>): void {
    const { page } = message;
    if (message.type === "state") {
      const { seq, state, at } = message;
      this.history.did({ seq, what: state, page, at });
      if (state === "started") this.starts.push({ seq, at });
      return;
    }
    if (message.type === "delivered") return this.history.given(message.seq, message.deadline);
    if (message.type === "status" && message.status.kind === "over") {
      if (message.status.reason === "replaced") this.replacedPages.add(page);
    }
    if (page !== this.page) return;
    if (message.type === "acquired") this.acquiredAt = message.at;
    if (message.type === "session") this.session = message.session;
    if (message.type === "motion") {
      this.isMoving = message.isMoving;
      this.movedAt = message.at;
    }
    if (message.type === "status") {
      const wasConnected = this.isConnected;
      this.status = message.status;
      if (this.isConnected && !wasConnected) this.connectedAt = message.at;
      if (!this.isConnected && wasConnected) this.disconnectedAt = message.at;
    }
  }

  /** All command records at its relay. */
  async log(origin: string): Promise<CommandRecord[]> {
    const { id, ownerKey } = this.registration;
    const all: CommandRecord[] = [];
    for (;;) {
      const after = all.at(-1)?.seq ?? 0;
      const answer = await fetch(`${origin}/api/v1/robots/${id}/commands?after=${after}`, {
        headers: { Authorization: `Bearer ${ownerKey}` },
      });
      if (!answer.ok) throw new Error(`the log request failed: ${answer.status}`);
      const { commands } = (await answer.json()) as { commands: CommandRecord[] };
      if (commands.length === 0) return all;
      all.push(...commands);
    }
  }

  /**
   * Waits until all commands have ended, for at most `withinMs`.
   * @param origin of a relay that answers requests
   */
  async waitUntilEnded(origin: string, withinMs: number): Promise<void> {
    for (const end = machineNow() + withinMs; machineNow() < end; await sleep(POLL_MS)) {
      const log = await this.log(origin);
      if (log.every(({ state }) => hasEnded(state))) return;
    }
  }

  /** @param origin of a relay that answers requests */
  async check(origin: string): Promise<{ faults: Fault[]; log: CommandRecord[] }> {
    const log = await this.log(origin);
    return { faults: this.history.check(log), log };
  }
}
