/**
 * Protocol of a script or a viewer. A script sends commands and receives records, states and
 * snapshots. A viewer only receives.
 */
import {
  closeReasons,
  decodeDriverFrame,
  encodeFrame,
  idempotencyKeySchema,
  PROTOCOL_VERSION,
  termsOf,
  type DriverToRelay,
  type EventGap,
  type Marks,
  type RelayToDriver,
  type StateEvent,
} from "@corridor/protocol";
import { z } from "zod";
import type { Clock } from "../../platform/time/clock.ts";
import type { ProblemKind } from "../../platform/errors/problem-kinds.ts";
import { asRefusal, badRequest, Refusal, retryAfter } from "../../platform/errors/problems.ts";
import type { CarriedSnapshot } from "../../bus/carried-snapshot.ts";
import { limits } from "../../platform/limits/limits.ts";
import { TokenBucket } from "../../platform/limits/token-bucket.ts";
import type { OverReason, ReaderSink, ReaderStart } from "../../robots/readers/feed.ts";
import type { Grant } from "../../robots/registry.ts";
import type { JoinedReader } from "../../robots/readers/readers.ts";
import { TransitEstimate } from "../../robots/delivery/script-clocks.ts";
import { withUntilHint } from "../requests/command-hints.ts";
import {
  closeWith,
  closeReader,
  type Conversation,
  type ClientConnection,
} from "./conversation.ts";

const keyedSchema = z.object({ key: idempotencyKeySchema });

/** Permission that each message type requires. */
const verbs = { command: "command", seen: "read", marks: "command" } as const;

type CommandMessage = Extract<DriverToRelay, { type: "command" }>;
type MarksMessage = Extract<DriverToRelay, { type: "marks" }>;

export interface DriverOptions {
  grant: Grant;
  connection: ClientConnection;
  /** the last event that it received on an earlier connection */
  since: string | null;
  /** when it sent its hello, by its own clock */
  sentAt: number | undefined;
  clock: Clock;
  /** called for every rejected message */
  onRefusal(kind: ProblemKind): void;
}

export class DriverConversation implements Conversation, ReaderSink {
  readonly transport: ReaderSink["transport"];
  readonly flow: ReaderSink["flow"];
  readonly #options: DriverOptions;
  readonly #reader: JoinedReader;
  /** a connection belongs to one script, and so to one clock */
  readonly #transit = new TransitEstimate();
  /** version of the rights at the last successful check, by message type */
  readonly #checkedAt = { command: -1, seen: -1, marks: -1 };
  #badFrames = 0;
  #tooFastInARow = 0;
  /** commands that wait for the store */
  #unfinished = 0;
  readonly #marksBucket: TokenBucket;
  #hasMarked = false;

  /**
   * Joins the robot as a reader, which sends the welcome.
   * @throws Refusal if the robot has too many readers
   */
  constructor(options: DriverOptions) {
    this.#options = options;
    const { grant, connection, since, sentAt, clock } = options;
    this.#marksBucket = new TokenBucket(limits.marksRate, clock.now());
    this.transport = connection.transport;
    this.flow = connection.flow;
    // Before the welcome: the time until it arrives bounds the transit time of the hello for the
    // script.
    this.#transitTime(sentAt);
    this.#reader = grant.robot.readers.join(grant.caller, this, since);
    grant.robot.spoke(grant.caller);
  }

  // --- messages to the client, as a ReaderSink ---

  began({ stream, n, snapshot }: ReaderStart): void {
    const newest = snapshot?.value ?? null;
    this.#send({ type: "welcome", version: PROTOCOL_VERSION, stream, n, snapshot: newest });
  }

  snapshot(snapshot: CarriedSnapshot): void {
    this.#options.connection.sendSnapshot(snapshot);
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

  /** Viewers show marks. Scripts do not. */
  marks(marks: Marks): void {
    if (this.#options.grant.caller.kind === "watch") this.#send({ type: "marks", ...marks });
  }

  over(reason: OverReason): void {
    closeReader(this.#options.connection, reason);
  }

  // --- messages from the client ---

  received(bytes: Buffer): Promise<void> | undefined {
    const text = bytes.toString();
    const { robot, caller } = this.#options.grant;
    const message = decodeDriverFrame(text);
    if (!message.ok) {
      return this.#refuse(
        badRequest("Invalid message.", withUntilHint(message.problems)),
        keyIn(text),
      );
    }
    const { value } = message;
    const { type } = value;
    // The result of a check holds until rights change or a second has passed.
    if (this.#checkedAt[type] !== robot.rights.value) {
      robot.check(caller, verbs[type]);
      this.#checkedAt[type] = robot.rights.value;
    }
    if (value.type === "command") {
      robot.spoke(caller);
      return this.#submit(value);
    }
    // Motions without an end continue while their script is active.
    if (caller.script !== null) robot.spoke(caller);
    if (value.type === "marks") return this.#mark(value);
    this.#reader.seen(value.seq);
    return undefined;
  }

  async #submit(message: CommandMessage): Promise<void> {
    const { robot, caller } = this.#options.grant;
    const { key = null, command, sentAt } = message;
    const terms = termsOf(command);
    terms.age += this.#transitTime(sentAt);
    const isStop = command.action === "stop";
    const maxUnfinished = limits.unfinishedCommands + (isStop ? limits.unfinishedStops : 0);
    this.#unfinished += 1;
    try {
      if (this.#unfinished > maxUnfinished) {
        const refusal = tooManyUnfinished();
        robot.refused(caller, refusal);
        throw refusal;
      }
      await robot.submit(caller, { key, ...terms }, (record) => {
        this.#tooFastInARow = 0;
        this.#send({ type: "ack", record });
      });
    } catch (error) {
      const refusal = asRefusal(error);
      if (refusal.kind !== "internal") this.#options.onRefusal(refusal.kind);
      this.#send({ type: "problem", problem: refusal.problem, key });
      // Stops never count against a script.
      if (refusal.kind === "too-fast" && !isStop) this.#countTooFast();
      // Internal errors also go to the log.
      if (refusal.kind === "internal") throw error;
    } finally {
      this.#unfinished -= 1;
    }
  }

  #mark({ fresh, pitch, cells }: MarksMessage): undefined {
    const waitMs = this.#marksBucket.take(this.#options.clock.now());
    if (waitMs > 0) {
      const refusal = tooManyMarks(waitMs);
      this.#options.onRefusal(refusal.kind);
      this.#send({ type: "problem", problem: refusal.problem, key: null });
      this.#countTooFast();
      return;
    }
    // The first message of a connection replaces the marks of others.
    this.#options.grant.robot.marks.publish({ fresh: fresh || !this.#hasMarked, pitch, cells });
    this.#hasMarked = true;
  }

  /** ms that a message took longer than the fastest one; 0 without a timestamp */
  #transitTime(sentAt: number | undefined): number {
    return sentAt === undefined ? 0 : this.#transit.measure(sentAt, this.#options.clock.now());
  }

  heartbeat(): void {
    this.#send({ type: "heartbeat" });
  }

  closed(): void {
    this.#reader.leave();
    if (!this.#hasMarked) return;
    this.#options.grant.robot.marks.publish({ fresh: true, pitch: 1, cells: [] });
  }

  #refuse(refusal: ReturnType<typeof badRequest>, key: string | null): undefined {
    this.#badFrames += 1;
    const { robot, caller } = this.#options.grant;
    robot.refused(caller, refusal);
    this.#options.onRefusal(refusal.kind);
    this.#send({ type: "problem", problem: refusal.problem, key });
    if (this.#badFrames >= limits.badFrames)
      closeWith(this.#options.connection, closeReasons.badFrame);
  }

  #countTooFast(): void {
    this.#tooFastInARow += 1;
    if (this.#tooFastInARow < limits.tooFastInARow) return;
    closeWith(
      this.#options.connection,
      closeReasons.badFrame,
      "Too many commands. Wait for the ack of each command before you send the next one.",
    );
  }

  #send(message: RelayToDriver): void {
    this.#options.connection.send(encodeFrame(message));
  }
}

/** Reads the idempotency key of an invalid message, so that its sender can identify it. */
function keyIn(text: string): string | null {
  try {
    return keyedSchema.parse(JSON.parse(text)).key;
  } catch {
    return null;
  }
}

/** With a slow store, the pending commands of a script that never waits could exhaust memory. */
function tooManyUnfinished(): Refusal {
  return new Refusal(
    "too-fast",
    "Too many unanswered commands. Wait for the responses, then send this command again.",
    { headers: retryAfter(1_000) },
  );
}

function tooManyMarks(waitMs: number): Refusal {
  return new Refusal(
    "too-fast",
    `Too many messages with marks: a script can send ${limits.marksRate.perSecond} a second. Send the newest marks later.`,
    { headers: retryAfter(waitMs) },
  );
}
