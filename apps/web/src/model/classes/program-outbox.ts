/** The newest program of the student: sent until the relay has stored it. A newer one replaces it. */
import type { ClassReport, ClassSession } from "../../simulator/protocol/class-messages.ts";
import type { OutboxPorts } from "./progress-outbox.ts";
import { ReportPace } from "./report-pace.ts";

/** Time after which an unconfirmed program is sent again, in ms. */
const REPEAT_MS = 6_000;

type Program = Extract<ClassReport, { type: "program" }>;

export class ProgramOutbox {
  readonly #ports: Omit<OutboxPorts, "tab">;
  readonly #pace: ReportPace;
  #newest: Program | null = null;
  /** number that the relay has confirmed last */
  #confirmed = 0;
  #isConnected = false;
  #cancel: () => void = () => undefined;

  constructor(ports: Omit<OutboxPorts, "tab">) {
    this.#ports = ports;
    this.#pace = new ReportPace(ports.now());
  }

  /** @param link text of a link with the program or the drive */
  set(task: number, link: string): void {
    const newest = this.#newest;
    if (newest?.task === task && newest.link === link) return;
    this.#newest = { type: "program", seq: (newest?.seq ?? 0) + 1, task, link };
    this.#send();
  }

  /** The worker has reported the connection, or what the relay has stored. */
  follow({ status, student }: ClassSession): void {
    const wasConnected = this.#isConnected;
    this.#isConnected = status.kind === "connected";
    this.#confirmed = student?.stored.program ?? 0;
    if (this.#isConnected && !wasConnected) this.#send();
  }

  close(): void {
    this.#isConnected = false;
    this.#cancel();
  }

  #send(): void {
    this.#cancel();
    const newest = this.#newest;
    if (!this.#isConnected || newest === null || newest.seq <= this.#confirmed) return;
    const wait = this.#pace.take(this.#ports.now());
    if (wait === 0) this.#ports.send(newest);
    this.#cancel = this.#ports.later(() => this.#send(), wait === 0 ? REPEAT_MS : wait);
  }
}
