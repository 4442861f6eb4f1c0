/** One robot of a row: who it is, the page that plays it, and all that is known of its commands. */
import type { CommandRecord, Registration } from "@corridor/protocol";
import { History, type Fault } from "../../../apps/relay/src/testing/faults/history.ts";
import type { RemoteSession, RemoteStatus } from "../../../apps/web/src/worker/worker-messages.ts";
import { wallClock } from "../clock.ts";
import type { FromPages } from "./page-messages.ts";

/** ms after its time to live within which a command may start */
const TOLERANCE_MS = 100;

export class Robot {
  readonly registration: Registration;
  readonly history = new History(TOLERANCE_MS, wallClock);
  /** what the tab keeps */
  session: RemoteSession;
  /** of the newest page */
  page = 0;
  status: RemoteStatus = { kind: "off" };
  isMoving = false;
  movedAt = 0;
  /** when the newest page was given the robot by the relay last */
  takenAt = 0;
  /** when the page was connected last, and when it lost its line last */
  connectedAt = 0;
  lostAt = 0;
  /** when which command was started, newest last */
  readonly starts: { seq: number; at: number }[] = [];
  /** pages that were told that another one has the robot */
  readonly losers = new Set<number>();

  constructor(registration: Registration) {
    this.registration = registration;
    this.session = { ...registration, lastApplied: 0 };
  }

  get isConnected(): boolean {
    return this.status.kind === "waiting" || this.status.kind === "connected";
  }

  /** One of its pages tells something. */
  heard(message: Exclude<FromPages, { tells: "ready" }>): void {
    const { page } = message;
    if (message.tells === "deed") {
      const { seq, what, at } = message;
      this.history.did({ seq, what, page, at });
      if (what === "started") this.starts.push({ seq, at });
      return;
    }
    if (message.tells === "given") return this.history.given(message.seq, message.deadline);
    if (message.tells === "status" && message.status.kind === "over") {
      if (message.status.reason === "replaced") this.losers.add(page);
    }
    if (page !== this.page) return;
    if (message.tells === "taken") this.takenAt = message.at;
    if (message.tells === "session") this.session = message.session;
    if (message.tells === "motion") {
      this.isMoving = message.isMoving;
      this.movedAt = message.at;
    }
    if (message.tells === "status") {
      const wasConnected = this.isConnected;
      this.status = message.status;
      if (this.isConnected && !wasConnected) this.connectedAt = message.at;
      if (!this.isConnected && wasConnected) this.lostAt = message.at;
    }
  }

  /** All that its relay has of its commands. */
  async log(origin: string): Promise<CommandRecord[]> {
    const { id, ownerKey } = this.registration;
    const all: CommandRecord[] = [];
    for (;;) {
      const after = all.at(-1)?.seq ?? 0;
      const answer = await fetch(`${origin}/api/v1/robots/${id}/commands?after=${after}`, {
        headers: { Authorization: `Bearer ${ownerKey}` },
      });
      if (!answer.ok) throw new Error(`the log was refused: ${answer.status}`);
      const { commands } = (await answer.json()) as { commands: CommandRecord[] };
      if (commands.length === 0) return all;
      all.push(...commands);
    }
  }

  /** @param origin of a relay that it can be asked of */
  async check(origin: string): Promise<{ faults: Fault[]; log: CommandRecord[] }> {
    const log = await this.log(origin);
    return { faults: this.history.check(log), log };
  }
}
