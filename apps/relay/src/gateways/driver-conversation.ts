/** A script's part: it sends commands and gets records, states and snapshots. A watcher's: it gets them. */
import {
  closeReasons,
  decodeDriverFrame,
  encodeFrame,
  idempotencyKeySchema,
  PROTOCOL_VERSION,
  termsOf,
  type DriverToRelay,
  type EventGap,
  type RelayToDriver,
  type StateEvent,
} from "@corridor/protocol";
import { z } from "zod";
import type { Clock } from "../clock.ts";
import type { ProblemKind } from "../problem-kinds.ts";
import { asRefusal, badRequest, Refusal, retryAfter } from "../problems.ts";
import type { CarriedSnapshot } from "../sessions/carried-snapshot.ts";
import { limits } from "../sessions/limits.ts";
import type { OverReason, ReaderSink, ReaderStart } from "../sessions/reader-feed.ts";
import type { Grant } from "../sessions/session-hub.ts";
import type { JoinedReader } from "../sessions/readers.ts";
import { TransitEstimate } from "../sessions/transit-estimate.ts";
import { closeWith, sayGoodbye, type Conversation } from "./conversation.ts";
import type { ReaderLine } from "./reader-line.ts";

const keyedSchema = z.object({ key: idempotencyKeySchema });

/** What it takes to say this. */
const verbs = { command: "command", seen: "read" } as const;

type CommandMessage = Extract<DriverToRelay, { type: "command" }>;

export interface DriverOptions {
  grant: Grant;
  line: ReaderLine;
  /** the last state that it was told on an earlier line */
  since: string | null;
  /** when it sent its hello, by its own clock */
  sentAt: number | undefined;
  clock: Clock;
  /** is told of every message that is refused */
  refused(kind: ProblemKind): void;
}

export class DriverConversation implements Conversation, ReaderSink {
  readonly door: ReaderSink["door"];
  readonly flow: ReaderSink["flow"];
  readonly #options: DriverOptions;
  readonly #reader: JoinedReader;
  /** one connection is of one script, and so of one clock */
  readonly #transit = new TransitEstimate();
  /** versions of the rights by which it may say this */
  readonly #mayAt = { command: -1, seen: -1 };
  #badFrames = 0;
  #tooFastInARow = 0;
  /** commands that wait for the store */
  #unfinished = 0;

  /**
   * Joins the session as a reader, which says welcome.
   * @throws Refusal when too many read already
   */
  constructor(options: DriverOptions) {
    this.#options = options;
    const { grant, line, since, sentAt } = options;
    this.door = line.door;
    this.flow = line.flow;
    // Before the welcome: by the time until that comes the script knows what its hello took at most.
    this.#transitOf(sentAt);
    this.#reader = grant.session.readers.join(grant.key, this, since);
    grant.session.spoke(grant.key);
  }

  // --- what it is told, as a reader ---

  began({ stream, n, snapshot }: ReaderStart): void {
    const newest = snapshot?.value ?? null;
    this.#send({ type: "welcome", version: PROTOCOL_VERSION, stream, n, snapshot: newest });
  }

  snapshot(snapshot: CarriedSnapshot): void {
    this.#options.line.pass(snapshot);
  }

  state(event: StateEvent): void {
    this.#send({ type: "state", ...event });
  }

  gap(gap: EventGap): void {
    this.#send({ type: "gap", ...gap });
  }

  maze(version: string): void {
    this.#send({ type: "maze", version });
  }

  over(reason: OverReason): void {
    sayGoodbye(this.#options.line, reason);
  }

  // --- what it says ---

  received(bytes: Buffer): Promise<void> | undefined {
    const text = bytes.toString();
    const { session, key: grant } = this.#options.grant;
    const message = decodeDriverFrame(text);
    if (!message.ok) {
      return this.#refuse(badRequest("The message is wrong.", message.problems), keyIn(text));
    }
    const { value } = message;
    const { type } = value;
    // What was found is found again until rights change, or a second has passed.
    if (this.#mayAt[type] !== session.rights.value) {
      session.check(grant, verbs[type]);
      this.#mayAt[type] = session.rights.value;
    }
    if (value.type === "command") {
      session.spoke(grant);
      return this.#submit(value);
    }
    // What a script wishes to go on with goes on for as long as it is heard.
    if (grant.script !== null) session.spoke(grant);
    this.#reader.seen(value.seq);
    return undefined;
  }

  async #submit(message: CommandMessage): Promise<void> {
    const { session, key: grant } = this.#options.grant;
    const { key = null, command, sentAt } = message;
    const terms = termsOf(command);
    terms.age += this.#transitOf(sentAt);
    const isStop = command.action === "stop";
    const most = limits.unfinishedCommands + (isStop ? limits.unfinishedStops : 0);
    this.#unfinished += 1;
    try {
      if (this.#unfinished > most) throw tooManyUnfinished();
      await session.submit(grant, { key, ...terms }, (record) => {
        this.#tooFastInARow = 0;
        this.#send({ type: "ack", record });
      });
    } catch (error) {
      const refusal = asRefusal(error);
      if (refusal.kind !== "internal") this.#options.refused(refusal.kind);
      this.#send({ type: "problem", problem: refusal.problem, key });
      // Nobody is sent away for stopping.
      if (refusal.kind === "too-fast" && !isStop) this.#countTooFast();
      // A mistake of the relay goes on to whoever writes the log.
      if (refusal.kind === "internal") throw error;
    } finally {
      this.#unfinished -= 1;
    }
  }

  /** ms that a message was on its way longer than the quickest one; 0 where it tells no time */
  #transitOf(sentAt: number | undefined): number {
    return sentAt === undefined ? 0 : this.#transit.came(sentAt, this.#options.clock.now());
  }

  heartbeat(): void {
    this.#send({ type: "heartbeat" });
  }

  closed(): void {
    this.#reader.leave();
  }

  #refuse(refusal: ReturnType<typeof badRequest>, key: string | null): undefined {
    this.#badFrames += 1;
    this.#options.refused(refusal.kind);
    this.#send({ type: "problem", problem: refusal.problem, key });
    if (this.#badFrames >= limits.badFrames) closeWith(this.#options.line, closeReasons.badFrame);
  }

  #countTooFast(): void {
    this.#tooFastInARow += 1;
    if (this.#tooFastInARow < limits.tooFastInARow) return;
    closeWith(
      this.#options.line,
      closeReasons.badFrame,
      "Too many commands came too fast. Wait for the ack of each before the next.",
    );
  }

  #send(message: RelayToDriver): void {
    this.#options.line.send(encodeFrame(message));
  }
}

/** The idempotency key in a message that is wrong otherwise, so that its sender knows which one it was. */
function keyIn(text: string): string | null {
  try {
    return keyedSchema.parse(JSON.parse(text)).key;
  } catch {
    return null;
  }
}

/** A store that takes long would let the commands of a script that waits for nothing fill the memory. */
function tooManyUnfinished(): Refusal {
  return new Refusal(
    "too-fast",
    "Too many commands came before the first were answered. Wait for the answers, then send this one again.",
    { headers: retryAfter(1_000) },
  );
}
