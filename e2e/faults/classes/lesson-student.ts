/**
 * A student of a class as the service sees it: joins with the code, connects, and reports numbered
 * progress and programs until the relay confirms them.
 */
import { StudentConnection, type ClassMessage } from "@corridor/client/learn";
import {
  joinedClassSchema,
  type JoinedClass,
  type Progress,
  type StudentToRelay,
} from "@corridor/protocol";
import { machineNow, sleep } from "../clock.ts";
import { platformFor } from "../platforms.ts";
import type { Transports } from "../robots/page-messages.ts";

const REPORT_INTERVAL_MS = 2_500;
const TILE_INTERVAL_MS = 500;
/** The relay accepts 10 reports at once, and then one in two seconds. */
const RESENT_AT_ONCE = 5;
const JOIN_RETRY_MS = 200;

export class LessonStudent {
  readonly joined: JoinedClass;
  readonly #connection: StudentConnection;
  readonly #timers: NodeJS.Timeout[];
  /** progress records in order; the number of a record is its index + 1 */
  readonly sent: Progress[] = [];
  /** links of programs in order; the number of a program is its index + 1 */
  readonly programs: string[] = [];
  /** numbers of the newest record and the newest program that the relay confirmed */
  confirmed = { progress: 0, program: 0 };
  connectedAt = -Infinity;
  #tiles = 0;

  /** Joins, however often it takes. @param originOf the address of the relay */
  static async join(
    code: string,
    originOf: () => string,
    transports: Transports,
  ): Promise<LessonStudent> {
    for (;;) {
      const joined = await tryJoin(originOf(), code);
      if (joined !== null) return new LessonStudent(joined, originOf(), transports);
      await sleep(JOIN_RETRY_MS);
    }
  }

  private constructor(joined: JoinedClass, origin: string, transports: Transports) {
    this.joined = joined;
    this.#connection = new StudentConnection({
      origin,
      id: joined.class,
      key: joined.key,
      onMessage: (message) => this.#receive(message),
      onStatus: ({ kind }) => {
        if (kind === "connected") this.connectedAt = machineNow();
      },
      platform: platformFor(transports),
    });
    this.#timers = [
      setInterval(() => this.#report(), REPORT_INTERVAL_MS),
      setInterval(() => this.#sendTile(), TILE_INTERVAL_MS),
    ];
  }

  get isConnected(): boolean {
    return this.#connection.isConnected;
  }

  get isConfirmed(): boolean {
    return (
      this.confirmed.progress === this.sent.length &&
      this.confirmed.program === this.programs.length
    );
  }

  /** Reports nothing new. Unconfirmed reports are still repeated. */
  finish(): void {
    for (const timer of this.#timers.splice(0)) clearInterval(timer);
    this.#timers.push(setInterval(() => this.#sendUnconfirmed(), REPORT_INTERVAL_MS));
  }

  close(): void {
    for (const timer of this.#timers) clearInterval(timer);
    this.#connection.close();
  }

  #receive(message: ClassMessage): void {
    if (message.type === "welcome") {
      this.confirmed.progress = Math.max(this.confirmed.progress, message.progress);
      // `onStatus` has not been called yet.
      setTimeout(() => this.#sendUnconfirmed());
    } else if (message.type === "stored") {
      const { what, seq } = message;
      this.confirmed[what] = Math.max(this.confirmed[what], seq);
    }
  }

  #report(): void {
    const n = this.sent.length + 1;
    this.sent.push({ kind: "run", task: 1, changed: true, bumps: n, mistakes: 0, failure: null });
    this.programs.push(`c1.${this.joined.student}-${n}`);
    this.#sendUnconfirmed();
  }

  #sendUnconfirmed(): void {
    const { progress, program } = this.confirmed;
    for (const [n, event] of this.sent.slice(progress, progress + RESENT_AT_ONCE).entries()) {
      this.#send({ type: "progress", seq: progress + n + 1, event });
    }
    const link = this.programs.at(-1);
    if (link === undefined || program === this.programs.length) return;
    this.#send({ type: "program", seq: this.programs.length, task: 1, link });
  }

  #sendTile(): void {
    const tile = {
      seq: (this.#tiles += 1),
      task: 1,
      maze: "g1",
      state: "driving",
      pose: [150, 150, 90],
      path: "e4s2",
      line: 1,
      tick: this.#tiles * 30,
      bumps: 0,
      passes: null,
    } as const;
    this.#send({ type: "tile", tile: { ...tile, pose: [...tile.pose] } });
  }

  #send(message: StudentToRelay): void {
    if (this.#connection.isConnected) this.#connection.send(message);
  }
}

/** @returns null if the relay did not respond */
async function tryJoin(origin: string, code: string): Promise<JoinedClass | null> {
  try {
    const response = await fetch(`${origin}/api/v1/joins`, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify({ code }),
    });
    return response.status === 201 ? joinedClassSchema.parse(await response.json()) : null;
  } catch {
    return null;
  }
}
